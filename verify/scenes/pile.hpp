#pragma once

#include <map>
#include <string>

#include "shipped.hpp"

/// The pile of marbles: what can be said of it without an analytic answer.
namespace verify::answers::pile {

// The file's data.
inline constexpr double radius = 0.01, width = 0.15, step = 2e-3, gravity = 9.81;
inline constexpr int count = 216;

/// A marble at rest moves, at most, as fast as gravity makes it in a step; in units of what it gave, a
/// centimetre of fall each at least.
inline constexpr double rest = gravity * step * step / 2 / 0.01;
/// Velocities are what contacts are solved for; a step of the fastest, from 0.13 m, may end beyond the wall
/// [m].
inline constexpr double depth = 1.6 * step;
/// The scheme's books are exact but for rounding: some 1e3 contacts in 250 steps.
inline constexpr double books = 1e-10;
/// A run is one more throw of the dice, and the deviation is known from five.
inline constexpr double most_deviations = 6;

struct Statistic {
  double mean, deviation;
};
using Spread = std::map<std::string, Statistic>;
/// reference_data/scenes/pile.tsv
Spread reference();
/// How far a centre is closer to a wall than a radius, in the end, the worst of all; negative: none is [m].
double deepest(const Shipped& run);

}  // namespace verify::answers::pile
