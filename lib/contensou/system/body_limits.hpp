#pragma once

#include <limits>

namespace contensou {

/// Lengths that are to be 1, and directions that are to agree: what a hand-written file may be off, some ten
/// digits.
inline constexpr double unit_tolerance = 1e-9;

/// Whether a principal moment of inertia is at most the sum of the other two, judged with the rounding of the
/// sum: a flat plate is a body, too.
inline bool at_most_sum(double moment, double second, double third) {
  return moment <= (second + third) * (1 + 4 * std::numeric_limits<double>::epsilon());
}

}  // namespace contensou
