#include "contensou/law/power.hpp"

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contensou/law/slip_ratio.hpp"

namespace contensou {
namespace {

constexpr double largest_n = 1e6;

/// (2/π) ∫_0^∞ exp(log_term(z)) dz by the trapezoidal rule, halved until two meshes agree to `agreement`: the
/// rule converges geometrically, so the mean of two meshes that agree to 1e-9 is good to the last bit.
template <class LogTerm>
double integrate(double mesh, const LogTerm& log_term) {
  constexpr double agreement = 1e-9;
  constexpr double negligible = 1e-18;
  const auto sum_from = [&](double start, double step) {
    double sum = 0;
    double previous = 0;
    for (int k = 0;; ++k) {
      const double term = std::exp(log_term(start + k * step));
      sum += term;
      if (term <= negligible * sum && term <= previous) return sum;
      previous = term;
    }
  };
  double trapezoid = mesh * (sum_from(mesh, mesh) + std::exp(log_term(0.0)) / 2);
  for (;;) {
    const double midpoint = mesh * sum_from(mesh / 2, mesh);
    const double difference = std::abs(trapezoid - midpoint);
    trapezoid = (trapezoid + midpoint) / 2;
    mesh /= 2;
    if (difference <= agreement * trapezoid) return 2 / std::numbers::pi * trapezoid;
  }
}

/// log cosh z to full relative accuracy for z >= 0 of any size.
double log_cosh(double z) {
  if (z > 1) return z + std::log1p(std::exp(-2 * z)) - std::numbers::ln2;
  const double sinh_z = std::sinh(z);
  return std::log1p(sinh_z * sinh_z) / 2;
}
double log_tanh2(double z) { return 2 * std::log(std::tanh(z)); }

/// z ↦ log(1 − x² tanh² z) without cancellation for every x in [0, 1).
struct Chord {
  explicit Chord(SlipRatio ratio) : x2(ratio.x * ratio.x), kappa(ratio.gap * (1 + ratio.x)) {}
  double log_base(double z) const {
    const double t = std::tanh(z);
    const double drop = x2 * t * t;
    return drop < 0.5 ? std::log1p(-drop) : std::log(kappa + x2 * std::exp(-2 * log_cosh(z)));
  }
  double x2;     // (min(v, s)/max(v, s))²
  double kappa;  // 1 − x²
};

double beta_with_half(double a) {  // B(a, 1/2)
  return std::sqrt(std::numbers::pi) * boost::math::tgamma_delta_ratio(a, 0.5);
}

}  // namespace

PowerQuadrature::PowerQuadrature(double n) : n_(n) {
  if (!(n > -1 && n <= largest_n)) {
    throw std::invalid_argument("power law: exponent " + std::to_string(n) + ", expected -1 < n <= 1e6");
  }
  xi_scale_ = std::sqrt(std::numbers::pi) / boost::math::tgamma_delta_ratio(n + 1.5, 0.5);
  eta_scale_ = xi_scale_ / (2 * n + 3);
}

BoundedForm PowerQuadrature::inner(SlipRatio u) const {
  if (u.gap == 0) {
    const double force = xi_scale_ / std::numbers::pi * beta_with_half(n_ + 2);
    return {force, force / (2 * n_ + 3),
            xi_scale_ / std::numbers::pi * beta_with_half(n_ + 1) / (2 * n_ + 3)};
  }
  const Chord chord(u);
  const double mesh = std::min(0.32, 1 / std::sqrt(3 + (2 * n_ + 3) * u.x * u.x));
  const double force =
      integrate(mesh, [&](double z) { return (n_ + 0.5) * chord.log_base(z) - 3 * log_cosh(z); });
  const double torque =
      integrate(mesh, [&](double z) { return (n_ + 1.5) * chord.log_base(z) - log_cosh(z); });
  const double second =
      integrate(mesh, [&](double z) { return log_tanh2(z) + (n_ + 0.5) * chord.log_base(z) - log_cosh(z); });
  return {xi_scale_ * force, eta_scale_ * torque, xi_scale_ * second};
}

BoundedForm PowerQuadrature::outer(SlipRatio w) const {
  if (w.gap == 0) return inner(w);
  const Chord chord(w);
  const double decay = 2 * n_ + 3;
  const double mesh = std::min(0.32, 1 / std::sqrt(2 + decay));
  const double force =
      integrate(mesh, [&](double z) { return 0.5 * chord.log_base(z) - decay * log_cosh(z); });
  const double torque =
      integrate(mesh, [&](double z) { return -0.5 * chord.log_base(z) - (decay + 2) * log_cosh(z); });
  const double second =
      integrate(mesh, [&](double z) { return log_tanh2(z) - 0.5 * chord.log_base(z) - decay * log_cosh(z); });
  return {xi_scale_ * force, eta_scale_ * torque, xi_scale_ * second};
}

Friction PowerQuadrature::at(double v, double s) const {
  return friction_from(
      v, s, [this](SlipRatio u) { return inner(u); }, [this](SlipRatio w) { return outer(w); });
}

Curvature PowerQuadrature::curvature(double v, double s) const {
  return curvature_from(
      v, s, [this](SlipRatio u) { return inner(u).second; }, [this](SlipRatio w) { return outer(w).second; });
}

PowerLaw::PowerLaw(const PowerQuadrature& law)
    : CompiledLaw([&law](SlipRatio u) { return law.inner(u); }, [&law](SlipRatio w) { return law.outer(w); },
                  law.extent(), 1e-14) {}

PowerLaw::PowerLaw(double n) : PowerLaw(PowerQuadrature(n)) {}

}  // namespace contensou
