#pragma once

#include <functional>
#include <string>
#include <vector>

namespace verify {

/// A radially symmetric pressure on the unit disc (R = 1),
/// scaled so that its integral over the disc is 1 (λ_N = 1).
struct Pressure {
  std::string name;
  /// σ at a radius ρ whose complement 1 − ρ² is given as well:
  /// near the edge it is the complement that is accurate.
  std::function<double(double rho, double complement)> sigma;
  std::vector<double> breaks;  ///< radii in (0, 1), ascending, where σ or its slope jumps
  /// Whether σ has a slope in ρ at the centre, a cone: its tip
  /// is then a singularity of the integrand like the pole.
  bool cone_at_centre = false;
};

/// σ = (n+1)/π (1 − ρ²)ⁿ, n > −1: n = 0 uniform, n = 1/2 Hertz, LG03 (3.4).
Pressure power_pressure(double n);

/// Linear between the points of a table over 0 = rho[0] < ... < rho[last] = 1; scaled by the exact integral
/// of that piecewise linear function.
Pressure tabulated(std::string name, std::vector<double> rho, std::vector<double> sigma);

}  // namespace verify
