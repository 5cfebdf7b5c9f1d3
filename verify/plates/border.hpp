#pragma once

#include <functional>

#include "contensou/ball/plate_series.hpp"

/// How well a friction plate made of two series stands for the exact one.
namespace verify::plates {

using contensou::Friction;
using contensou::PlateSeries;

/// The exact border point (ξ, η) where the outward normal is (sin ψ, cos ψ), 0 < ψ < π/2 (u = tan ψ).
using Border = std::function<Friction(double psi)>;

/// Distance from the exact border to the plate's, along the
/// exact normal: positive where the plate reaches too far.
struct Deviation {
  double distance;  ///< in units of μλ_N, with its sign
  double xi;        ///< of the exact border point
  double u;
};

/// The largest deviation over 4000 directions and 100 more that close in on the seam u = 1 from both sides.
/// Distances below 1e-15 are rounding.
Deviation largest_deviation(const PlateSeries& plate, const Border& exact);

/// η just outside the seam less η just inside it; > 0 is a step
/// outwards: the plate then lacks its own limit points there.
double jump(const PlateSeries& plate);

/// How far, in η, the border lies below the convex hull of the plate; 0 for a convex one.
double hull_gap(const PlateSeries& plate);

}  // namespace verify::plates
