#include "radial_breaks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verify {

std::vector<double> radial_breaks(double u, const Pressure& pressure) {
  constexpr double growth = 8;
  constexpr double whole = std::numbers::pi / 2;
  const double pole = u < 1 ? std::acos(u) : 0;
  // ρ = cos t: at the edge a distance d of the pole is √(2d) in t.
  const double layer = u < 1 ? std::min(pole, whole - pole) : std::sqrt(2 * (u - 1));
  std::vector<double> breaks{pole};
  for (double distance = layer; distance > 0 && distance < whole; distance *= growth) {
    breaks.push_back(pole - distance);
    breaks.push_back(pole + distance);
  }
  for (const double rho : pressure.breaks) breaks.push_back(std::acos(rho));
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

}  // namespace verify
