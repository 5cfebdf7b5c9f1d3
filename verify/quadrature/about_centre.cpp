#include "about_centre.hpp"

#include <numbers>

#include "radial_breaks.hpp"

namespace verify {
namespace {

using std::numbers::pi;

/// Four elements of one ring together: the mean of the quantity over ±χ and π ± χ, χ in (0, π/2).
/// `gap` is ρ − u, given apart because near the pole it is much more accurate than the difference of the two.
double four_elements(Quantity quantity, double u, double rho, double gap, double chi) {
  const double half_sine = std::sin(chi / 2);
  const double half_cosine = std::cos(chi / 2);
  const double near = std::sqrt(gap * gap + 4 * u * rho * half_sine * half_sine);     // |w| at ±χ
  const double far = std::sqrt(gap * gap + 4 * u * rho * half_cosine * half_cosine);  // |w| at π ± χ
  const double sum = near + far;
  const double cosine = std::cos(chi);
  const double sine = std::sin(chi);
  switch (quantity) {
    case Quantity::potential:
      return sum / 2;
    // (u − ρ cos χ)/near + (u + ρ cos χ)/far with far² − near² = 4uρ cos χ, and the same with u and ρ
    // exchanged: the brackets are positive by the triangle inequality.
    case Quantity::force:
      return u * (sum - 2 * rho * cosine) * (sum + 2 * rho * cosine) / (2 * near * far * sum);
    case Quantity::torque:
      return rho * rho * (sum - 2 * u * cosine) * (sum + 2 * u * cosine) / (2 * near * far * sum);
    case Quantity::curvature: {
      const double cross = rho * sine;
      return ((cross / near) * (cross / near) / near + (cross / far) * (cross / far) / far) / 2;
    }
    case Quantity::load:
      return 1;
  }
  return 0;
}

}  // namespace

Estimate AboutCentre::operator()(Quantity quantity, double u) {
  // ρ = cos t, so that the edge of the pressure, (1 − ρ²)ⁿ, is sin^2n t: no loss of digits in 1 − ρ², and
  // smooth at t = 0 for whole and half-whole n.
  const auto radial = [&](double t) {
    const double rho = std::cos(t);
    const double sine = std::sin(t);
    const double gap = (1 - u) - 2 * std::sin(t / 2) * std::sin(t / 2);
    const double width = std::abs(gap) / std::sqrt(u * rho);  // |w| vanishes near χ = ±i width
    const Estimate quarter = rings_.integrate_near_pole(
        [&](double chi) { return four_elements(quantity, u, rho, gap, chi); }, pi / 2, width);
    return pressure_.sigma(rho, sine * sine) * 4 * quarter.value * rho * sine;
  };
  Estimate e = radial_.integrate(radial, 0, pi / 2, radial_breaks(u, pressure_));
  e.error += inner_tolerance * std::abs(e.value);
  return e;
}

}  // namespace verify
