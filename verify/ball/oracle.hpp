#pragma once

#include <functional>
#include <vector>

#include "contensou/ball/plate_series.hpp"

/// Friction plates in long double, from formulas that share no code with the library.
namespace verify::ball {

using Real = long double;

/// A point and a unit normal of the quarter plane, or a share of it.
struct Pair {
  Real t;
  Real tau;
};

/// How far the point q of the plate of size 1 is from being the border point whose unit outward normal is n;
/// NaN where the oracle has no say.
using Oracle = std::function<Real(Pair q, Pair n)>;

/// A share of the load with the pressure σ ∝ (1 − ρ²/R²)ⁿ, and that pressure's η_max.
struct Share {
  Real n;
  Real eta_max;
  Real weight;
};

/// The exact plate of a sum of pressures (borders at one normal add as loads do) by Gauss's hypergeometric
/// series (laws.md) for normals with min(u, 1/u)² <= ½, as long as the inner series has no large terms;
/// nearer to the seam n = 0 by the arithmetic-geometric mean, n = ½ by LG03 (3.17), (3.18), other n not at
/// all.
Oracle exact_oracle(std::vector<Share> shares);

/// The ellipsoid and the rectangle with semi-axes (a, b); b = 0: the disk.
Oracle ellipsoid_oracle(Real a, Real b);
Oracle rectangle_oracle(Real a, Real b);

/// LG03 (2.18), (3.19): how far q is from the border of the piece it is on (left side − 1 over its gradient),
/// or from the step between the two.
Oracle series_oracle(contensou::PlateSeries series);

}  // namespace verify::ball
