#include "contensou/law/power.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contensou/law/slip_ratio.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

/// The three bounded forms side by side.
using Three = Eigen::Array3d;

/// (2/π) ∫_0^∞ integrand(z) dz of an even, positive integrand by the trapezoidal rule, halved until two
/// meshes agree to `agreement`: the rule converges geometrically, so the mean of two meshes that agree to
/// 1e-9 is good to the last bit.
template <class Integrand>
Three integrate(double mesh, const Integrand& integrand) {
  constexpr double agreement = 1e-9;
  constexpr double negligible = 1e-18;
  const auto sum_from = [&](double start, double step) -> Three {
    Three sum = Three::Zero();
    Three previous = Three::Zero();
    for (int k = 0;; ++k) {
      const Three term = integrand(start + k * step);
      sum += term;
      if ((term <= negligible * sum && term <= previous).all()) return sum;
      previous = term;
    }
  };
  Three trapezoid = mesh * (sum_from(mesh, mesh) + integrand(0.0) / 2);
  for (;;) {
    const Three midpoint = mesh * sum_from(mesh / 2, mesh);
    const Three difference = (trapezoid - midpoint).abs();
    trapezoid = (trapezoid + midpoint) / 2;
    mesh /= 2;
    if ((difference <= agreement * trapezoid).all()) return 2 / std::numbers::pi * trapezoid;
  }
}

/// log cosh z to full relative accuracy for z >= 0 of any size.
double log_cosh(double z) {
  if (z > 1) return z + std::log1p(std::exp(-2 * z)) - std::numbers::ln2;
  const double sinh_z = std::sinh(z);
  return std::log1p(sinh_z * sinh_z) / 2;
}

/// What the integrands are made of, at one z; b = 1 − x² tanh² z is the squared half chord over its largest,
/// formed without cancellation for every x in [0, 1), and so is its logarithm.
struct Chord {
  Chord(SlipRatio ratio, double z)
      : log_cosh_z(log_cosh(z)), sech(std::exp(-log_cosh_z)), tanh2(std::tanh(z) * std::tanh(z)) {
    const double drop = ratio.x * ratio.x * tanh2;
    b = drop < 0.5 ? 1 - drop : ratio.gap * (1 + ratio.x) + ratio.x * ratio.x * sech * sech;
    log_b = drop < 0.5 ? std::log1p(-drop) : std::log(b);
  }
  double log_cosh_z;
  double sech;
  double tanh2;
  double b;
  double log_b;
};

double beta_with_half(double a) {  // B(a, 1/2)
  return std::sqrt(std::numbers::pi) * boost::math::tgamma_delta_ratio(a, 0.5);
}

}  // namespace

PowerQuadrature::PowerQuadrature(double n) : n_(n) {
  if (!(n > -1 && n <= largest_n)) {
    throw std::invalid_argument("power law: exponent " + to_text(n) + ", expected -1 < n <= 1e6");
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
  const double mesh = std::min(0.32, 1 / std::sqrt(3 + (2 * n_ + 3) * u.x * u.x));
  const Three form = integrate(mesh, [&](double z) -> Three {
    const Chord c(u, z);
    const double weight = std::exp((n_ + 0.5) * c.log_b) * c.sech;
    return {weight * c.sech * c.sech, weight * c.b, weight * c.tanh2};
  });
  return {xi_scale_ * form[0], eta_scale_ * form[1], xi_scale_ * form[2]};
}

BoundedForm PowerQuadrature::outer(SlipRatio w) const {
  if (w.gap == 0) return inner(w);
  const double decay = 2 * n_ + 3;
  const double mesh = std::min(0.32, 1 / std::sqrt(2 + decay));
  const Three form = integrate(mesh, [&](double z) -> Three {
    const Chord c(w, z);
    const double weight = std::exp(-decay * c.log_cosh_z);
    const double root = std::sqrt(c.b);
    return {weight * root, weight * c.sech * c.sech / root, weight * c.tanh2 / root};
  });
  return {xi_scale_ * form[0], eta_scale_ * form[1], xi_scale_ * form[2]};
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
