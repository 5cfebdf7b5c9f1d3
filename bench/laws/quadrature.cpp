#include "quadrature.hpp"

#include <cmath>
#include <numbers>

namespace bench {
namespace {

using std::numbers::pi;
constexpr std::size_t intervals = 1000;

Workspace make_workspace() {
  return Workspace(gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
}

template <class F>
gsl_function as_gsl(const F& f) {
  // GSL's context is not const, but f is only called.
  return {[](double x, void* context) { return (*static_cast<const F*>(context))(x); }, const_cast<F*>(&f)};
}

// GSL's status is not looked at: where it gives up (round-off,
// too many intervals) its best value counts, with its error.
template <class F>
double qag(const F& f, double a, double b, double tolerance, gsl_integration_workspace* workspace) {
  double result = 0;
  double estimate = 0;
  const gsl_function g = as_gsl(f);
  gsl_integration_qag(&g, a, b, tolerance, 0, intervals, GSL_INTEG_GAUSS21, workspace, &result, &estimate);
  return result;
}

template <class F>
double qags(const F& f, double a, double b, double tolerance, gsl_integration_workspace* workspace) {
  double result = 0;
  double estimate = 0;
  const gsl_function g = as_gsl(f);
  gsl_integration_qags(&g, a, b, tolerance, 0, intervals, workspace, &result, &estimate);
  return result;
}

contensou::Reduced with_potential(double u, double xi, double eta) {
  return {(u * xi + eta) / std::hypot(u, 1.0), xi, eta};
}

/// x^(twice/2), twice >= 0.
double half_power(double x, int twice) {
  double result = twice % 2 == 1 ? std::sqrt(x) : 1;
  for (int k = twice / 2; k > 0; --k) result *= x;
  return result;
}

}  // namespace

DefinitionQuadrature::DefinitionQuadrature(int twice_n, double tolerance)
    : twice_n_(twice_n), tolerance_(tolerance), radial_(make_workspace()), angular_(make_workspace()) {}

contensou::Reduced DefinitionQuadrature::operator()(double u) const {
  const auto over_disc = [&](auto&& element) {
    const auto ring = [&](double rho) {
      const auto integrand = [&](double phi) {
        const double sine = std::sin(phi);
        const double w = std::hypot(u - rho * sine, rho * std::cos(phi));
        return w > 0 ? element(rho, sine) / w : 0.0;
      };
      // The disc is symmetric about e_2: φ from −π/2 to π/2, twice.
      const double angular = qag(integrand, -pi / 2, pi / 2, tolerance_ / 10, angular_.get());
      return (twice_n_ + 2) / pi * rho * half_power((1 - rho) * (1 + rho), twice_n_) * angular;
    };
    if (u >= 1) return qags(ring, 0, 1, tolerance_, radial_.get());
    return qags(ring, 0, u, tolerance_ / 2, radial_.get()) + qags(ring, u, 1, tolerance_ / 2, radial_.get());
  };
  return with_potential(u, over_disc([u](double rho, double sine) { return u - rho * sine; }),
                        over_disc([u](double rho, double sine) { return rho * (rho - u * sine); }));
}

ChordIntegrals::ChordIntegrals(int twice_n)
    : twice_n_(twice_n),
      force_scale_((twice_n + 2) / pi * std::beta(0.5, 0.5 * twice_n + 1)),
      torque_scale_(force_scale_ / (twice_n + 3)) {}

template <class Rule>
contensou::Reduced ChordIntegrals::at(double u, const Rule& rule) const {
  if (u <= 1) {
    const double u2 = u * u;
    const auto force = [&](double t) {
      const double sine = std::sin(t);
      return (1 - sine * sine) * half_power(1 - u2 * sine * sine, twice_n_ + 1);
    };
    const auto torque = [&](double t) {
      const double sine = std::sin(t);
      return half_power(1 - u2 * sine * sine, twice_n_ + 3);
    };
    return with_potential(u, force_scale_ * u * rule(force), torque_scale_ * rule(torque));
  }
  const double w2 = 1 / (u * u);
  const auto force = [&](double t) {
    const double cosine = std::cos(t);
    return half_power(cosine, 2 * twice_n_ + 4) * std::sqrt(1 - w2 * (1 - cosine * cosine));
  };
  const auto torque = [&](double t) {
    const double cosine = std::cos(t);
    return half_power(cosine, 2 * twice_n_ + 8) / std::sqrt(1 - w2 * (1 - cosine * cosine));
  };
  return with_potential(u, force_scale_ * rule(force), torque_scale_ / u * rule(torque));
}

ChordAdaptive::ChordAdaptive(int twice_n, Rule rule, double tolerance)
    : integrals_(twice_n), rule_(rule), tolerance_(tolerance), workspace_(make_workspace()) {}

contensou::Reduced ChordAdaptive::operator()(double u) const {
  return integrals_.at(u, [this](auto&& integrand) {
    return rule_ == Rule::qag ? qag(integrand, 0, pi / 2, tolerance_, workspace_.get())
                              : qags(integrand, 0, pi / 2, tolerance_, workspace_.get());
  });
}

ChordGauss::ChordGauss(int twice_n, std::size_t points)
    : integrals_(twice_n),
      table_(gsl_integration_glfixed_table_alloc(points), gsl_integration_glfixed_table_free) {}

contensou::Reduced ChordGauss::operator()(double u) const {
  return integrals_.at(u, [this](auto&& integrand) {
    const gsl_function g = as_gsl(integrand);
    return gsl_integration_glfixed(&g, 0, pi / 2, table_.get());
  });
}

}  // namespace bench
