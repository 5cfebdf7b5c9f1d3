#include "contensou/integrate/coulomb_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {
namespace {

// Beyond the first, all but the torque of 2^-60 is sliding friction; below the second, nothing is.
constexpr double largest_exponent = 60;
constexpr double least_exponent = -30;
constexpr double resolution = 1e-6;

/// max(1 − ξ, η) on a variant that is known to hold this kind of friction.
template <class Domain>
struct Kind;

template <class Law>
struct Kind<FrictionBall<SmoothPlate<Law>>> {
  static double error(const AnyFriction& friction, double v, double s) {
    const Friction f = std::get<FrictionBall<SmoothPlate<Law>>>(friction).plate().law().at(v, s);
    return std::max(1 - f.xi, f.eta);
  }
};

template <>
struct Kind<FrictionCylinder> {
  static double error(const AnyFriction& friction, double, double) {
    return std::get<FrictionCylinder>(friction).eta_max();
  }
};

}  // namespace

CoulombLimit::CoulombLimit() : slip_ratio_(std::numeric_limits<double>::infinity()) {}

CoulombLimit::CoulombLimit(const AnyFriction& friction, double fidelity) : CoulombLimit() {
  friction_ = &friction;
  std::visit(
      [this]<class Domain>(const Domain&) {
        if constexpr (Domain::dimension == 3) error_ = Kind<Domain>::error;
      },
      friction);
  double high = largest_exponent;
  if (error_ == nullptr || error(std::exp2(high), 1) > fidelity) return;
  double low = least_exponent;
  while (high - low > resolution) {
    const double middle = (low + high) / 2;
    (error(std::exp2(middle), 1) <= fidelity ? high : low) = middle;
  }
  slip_ratio_ = std::exp2(high);
}

double CoulombLimit::bound(double v, double s) {
  constexpr double farthest = 1.1;
  constexpr double below = 1.05;
  const double u = std::min(v / s, std::exp2(largest_exponent));
  if (!(u >= known_at_ && u <= farthest * known_at_)) {
    known_at_ = std::max(slip_ratio_, u / below);
    known_ = error(known_at_, 1);
  }
  return known_;
}

}  // namespace contensou
