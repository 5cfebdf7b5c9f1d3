#include "surface_elements.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "radial_breaks.hpp"

namespace verify {
namespace {

using std::numbers::pi;

/// Integrates mu sigma g(w, x) over the disc, where g is bounded by `scale`; in units of μλ_N scale.
template <class ElementQuantity>
double over_disc(const Contact& c, const Pressure& pressure, double scale, const ElementQuantity& g) {
  Adaptive rings(inner_tolerance, inner_tolerance * 2 * pi * scale);
  Adaptive radial(outer_tolerance, outer_tolerance * scale);
  const double v = std::hypot(c.gamma_t1, c.gamma_t2);
  const double s = std::abs(c.omega) * c.radius;
  // The pole w = 0 lies at x = (−γ_T2, γ_T1)/ω; without spin there is none, and any direction serves.
  const double towards_pole = c.omega == 0 ? 0 : std::atan2(c.gamma_t1 / c.omega, -c.gamma_t2 / c.omega);
  const auto ring = [&](double t) {
    const double rho = std::cos(t);
    const double width = s * rho > 0 && v > 0 ? std::abs(v - s * rho) / std::sqrt(v * s * rho) : 0;
    double sum = 0;
    for (const double side : {-1.0, 1.0}) {
      const auto element = [&](double chi) {
        const double phi = towards_pole + side * chi;
        const double x = c.radius * rho * std::cos(phi);
        const double y = c.radius * rho * std::sin(phi);
        return g(c.gamma_t1 - c.omega * y, c.gamma_t2 + c.omega * x, x, y);
      };
      sum += rings.integrate_near_pole(element, pi, width).value;
    }
    return pressure.sigma(rho, std::sin(t) * std::sin(t)) * sum * rho * std::sin(t);
  };
  const double u = s > 0 ? v / s : std::numeric_limits<double>::infinity();
  return c.mu * c.lambda_n * radial.integrate(ring, 0, pi / 2, radial_breaks(u, pressure)).value;
}

}  // namespace

Eigen::Vector3d friction_of_elements(const Contact& c, const Pressure& pressure) {
  return {over_disc(c, pressure, 1,
                    [](double w1, double w2, double, double) { return -w1 / std::hypot(w1, w2); }),
          over_disc(c, pressure, 1,
                    [](double w1, double w2, double, double) { return -w2 / std::hypot(w1, w2); }),
          over_disc(c, pressure, 1, [&](double w1, double w2, double x, double y) {
            return -(x * w2 - y * w1) / std::hypot(w1, w2) / c.radius;
          })};
}

Eigen::Matrix3d hessian_of_elements(const Contact& c, const Pressure& pressure) {
  const double fastest = std::max(std::hypot(c.gamma_t1, c.gamma_t2), std::abs(c.omega) * c.radius);
  Eigen::Matrix3d h;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      h(i, j) = h(j, i) = over_disc(c, pressure, 1 / fastest, [&](double w1, double w2, double x, double y) {
        // (I − w wᵀ/|w|²) = p pᵀ with p across w; Gᵀ p has these components.
        const double speed = std::hypot(w1, w2);
        const double p1 = -w2 / speed;
        const double p2 = w1 / speed;
        const std::array gp{p1, p2, (x * p2 - y * p1) / c.radius};
        return gp[static_cast<std::size_t>(i)] * gp[static_cast<std::size_t>(j)] / speed;
      });
    }
  }
  return h;
}

double power_of_elements(const Contact& c, const Pressure& pressure) {
  const double fastest = std::hypot(c.gamma_t1, c.gamma_t2) + std::abs(c.omega) * c.radius;
  return over_disc(c, pressure, fastest,
                   [](double w1, double w2, double, double) { return std::hypot(w1, w2); });
}

}  // namespace verify
