#include "contensou/law/force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "contensou/text/number.hpp"

namespace contensou::detail {
namespace {

double checked(const char* name, double x) {
  if (!(x >= 0 && std::isfinite(x))) {
    throw std::invalid_argument(std::string(name) + " " + to_text(x) + ": expected a finite number >= 0");
  }
  return x;
}

// Within these bounds no product or quotient of the few below leaves the normal range, and scaling by powers
// of two is not needed: doing without it gives the same bits in a fraction of the time.
constexpr double small_speed = 0x1p-100;
constexpr double large_speed = 0x1p100;
constexpr double small_load = 0x1p-400;
constexpr double large_load = 0x1p400;

bool comfortable(double speed) { return speed == 0 || (speed >= small_speed && speed <= large_speed); }

/// The k with 2^k <= x < 2^(k+1), also for subnormal x; 0 for x = 0.
int exponent_of(double x) { return x == 0 ? 0 : std::ilogb(x); }

/// 2^exponent x; for x > 0 never zero: a law must be able to tell little slip from none.
double scaled_speed(double x, int exponent) {
  if (x == 0 || exponent == 0) return x;
  return std::max(std::ldexp(x, exponent), std::numeric_limits<double>::denorm_min());
}

/// factor 2^exponent with one rounding, and +0 for −0.
double assembled(double factor, int exponent) {
  return (exponent == 0 ? factor : std::ldexp(factor, exponent)) + 0.0;
}

// Where ξ is below this part of its maximum the law is taken to be in its linear regime, where ξ/v and ∂ξ/∂v
// agree to the same relative accuracy; ξ/v itself loses digits once ξ or v is subnormal.
constexpr double linear_regime = 0x1p-500;

}  // namespace

ScaledLoad scaled(const Load& load) {
  const double product =
      checked("friction coefficient mu", load.mu) * checked("normal force lambda_n", load.lambda_n);
  if (product >= small_load && product <= large_load) return {product, 0};
  int mu_exponent = 0;
  int lambda_exponent = 0;
  const double mu = std::frexp(load.mu, &mu_exponent);
  const double lambda = std::frexp(load.lambda_n, &lambda_exponent);
  return {mu * lambda, mu_exponent + lambda_exponent};
}

ScaledSlip scaled(const SlipVelocity& gamma, bool free) {
  const double largest_t = std::max(std::abs(gamma[0]), std::abs(gamma[1]));
  const double spin_speed = std::abs(gamma[2]);
  double t1 = gamma[0];
  double t2 = gamma[1];
  int exponent_t = 0;
  ScaledSlip slip{};
  if (!(comfortable(largest_t) && comfortable(spin_speed) && !std::isnan(t1 + t2))) {
    if (!gamma.allFinite()) {
      throw std::domain_error("slip velocity (" + to_text(gamma[0]) + ", " + to_text(gamma[1]) + ", " +
                              to_text(gamma[2]) + "): expected finite numbers");
    }
    // The tangential part has its own exponent, so that its
    // length and direction do not suffer from being small.
    exponent_t = exponent_of(largest_t);
    t1 = std::ldexp(t1, -exponent_t);
    t2 = std::ldexp(t2, -exponent_t);
    if (free) slip.exponent = exponent_of(std::max(largest_t, spin_speed));
  }
  // As t is near 1, or at least comfortable, the root needs no hypot.
  const double length = std::sqrt(t1 * t1 + t2 * t2);
  slip.v = scaled_speed(length, exponent_t - slip.exponent);
  slip.s = scaled_speed(spin_speed, -slip.exponent);
  slip.n1 = length > 0 ? t1 / length : 1.0;
  slip.n2 = length > 0 ? t2 / length : 0.0;
  slip.spin = gamma[2] > 0 ? 1.0 : gamma[2] < 0 ? -1.0 : 0.0;
  return slip;
}

FrictionForce assemble_force(const ScaledLoad& load, const ScaledSlip& slip, const Friction& friction) {
  const double tangential = -load.factor * friction.xi;
  const double spin = -load.factor * friction.eta;
  return {assembled(tangential * slip.n1, load.exponent), assembled(tangential * slip.n2, load.exponent),
          assembled(spin * slip.spin, load.exponent)};
}

FrictionSet assemble_set(const ScaledLoad& load, const Extent& extent) {
  return {assembled(load.factor * extent.xi, load.exponent),
          assembled(load.factor * extent.eta, load.exponent)};
}

double assemble_potential(const ScaledLoad& load, int exponent, double reduced) {
  if (load.factor == 0) return 0;
  return assembled(load.factor * reduced, load.exponent + exponent);
}

Eigen::Matrix3d assemble_hessian(const ScaledLoad& load, const ScaledSlip& slip, const Friction& friction,
                                 const Curvature& curvature, const Extent& extent) {
  const double radial = curvature.vv;
  const double transverse = friction.xi < linear_regime * extent.xi ? radial : friction.xi / slip.v;
  const double mixed = curvature.vs * slip.spin;
  if (!std::isfinite(radial) || !std::isfinite(transverse) || !std::isfinite(curvature.ss)) {
    throw std::domain_error("hessian: the potential of this law has no second derivative here");
  }
  const auto [n1, n2] = std::pair{slip.n1, slip.n2};
  const auto entry = [&](double value) {
    return assembled(load.factor * value, load.exponent - slip.exponent);
  };
  const double off = entry(n1 * n2 * (radial - transverse));
  const double m1 = entry(mixed * n1);
  const double m2 = entry(mixed * n2);
  Eigen::Matrix3d h;
  h << entry(radial * n1 * n1 + transverse * n2 * n2), off, m1,  //
      off, entry(radial * n2 * n2 + transverse * n1 * n1), m2,   //
      m1, m2, entry(curvature.ss);
  return h;
}

void no_derivative_at_rest() {
  throw std::domain_error("hessian: at rest the friction is a set and the potential has no derivative");
}

}  // namespace contensou::detail
