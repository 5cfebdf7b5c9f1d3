#include "contensou/law/approximations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contensou/law/slip_ratio.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double positive(const char* what, double x) {
  if (!(x > 0 && std::isfinite(x))) {
    throw std::invalid_argument(std::string(what) + " " + to_text(x) + ": expected a finite number > 0");
  }
  return x;
}

Extent positive(Extent axes) {
  return {positive("semi-axis xi", axes.xi), positive("semi-axis eta", axes.eta)};
}

}  // namespace

// ---------------------------------------------------------------------------------------------- ellipsoid

EllipsoidLaw::EllipsoidLaw(Extent semi_axes) : axes_(positive(semi_axes)) {
  const double a = axes_.xi;
  const double b = axes_.eta;
  if (std::isinf(a * (a / b)) || std::isinf(b * (b / a))) {
    throw std::invalid_argument("semi-axes " + to_text(a) + " and " + to_text(b) +
                                ": so different that the curvature of the ellipsoid is no double");
  }
}

Friction EllipsoidLaw::at(double v, double s) const {
  const double a = axes_.xi;
  const double b = axes_.eta;
  // The quotients before the products: a² may overflow, a (a/h) does so only if the result does.
  const auto form = [=](double h) { return BoundedForm{a * (a / h), b * (b / h), 0}; };
  return friction_from(
      v, s, [&](SlipRatio u) { return form(std::hypot(a * u.x, b)); },
      [&](SlipRatio w) { return form(std::hypot(a, b * w.x)); });
}

Curvature EllipsoidLaw::curvature(double v, double s) const {
  const double a = axes_.xi;
  const double b = axes_.eta;
  // a²b²/h³, where other/h <= 1.
  const auto second = [](double axis, double other, double h) {
    return axis * (axis / h) * (other / h) * (other / h);
  };
  return curvature_from(
      v, s, [&](SlipRatio u) { return second(a, b, std::hypot(a * u.x, b)); },
      [&](SlipRatio w) { return second(b, a, std::hypot(a, b * w.x)); });
}

// ------------------------------------------------------------------------------------- disk × interval

DecoupledLaw::DecoupledLaw(Extent semi_axes) : axes_(positive(semi_axes)) {}

Friction DecoupledLaw::at(double v, double s) const {
  require_slip(v, s);
  return {v > 0 ? axes_.xi : 0.0, s > 0 ? axes_.eta : 0.0};
}

Curvature DecoupledLaw::curvature(double v, double s) const {
  require_slip(v, s);
  return {v > 0 ? 0.0 : infinity, 0.0, s > 0 ? 0.0 : infinity};
}

// ---------------------------------------------------------------------------------------------- Padé

PadeLaw::PadeLaw(int order, double eta_max, double slope, double tail)
    : order_(order), eta_max_(positive("eta_max", eta_max)), a_(1 / positive("slope", slope)) {
  positive("tail", tail);
  if (order == 1) {
    c_ = 0;
    b_ = eta_max / tail;
  } else if (order == 2) {
    c_ = slope / (2 * eta_max);
    b_ = c_ * tail / eta_max;
  } else {
    throw std::invalid_argument("Pade order " + std::to_string(order) + ": expected 1 or 2");
  }
  // So that no product of the few below leaves the range of doubles.
  constexpr double largest = 1e70;
  for (const double x : {eta_max_, a_, b_, order == 2 ? c_ : 1.0}) {
    if (!(x >= 1 / largest && x <= largest)) {
      throw std::invalid_argument("Pade with eta_max " + to_text(eta_max) + ", slope " + to_text(slope) +
                                  ", tail " + to_text(tail) + ": expected a, b, c between 1e-70 and 1e70");
    }
  }
}

Friction PadeLaw::at(double v, double s) const {
  return friction_from(
      v, s,
      [this](SlipRatio ratio) {
        const double u = ratio.x;
        if (order_ == 1) return BoundedForm{1 / (u + a_), eta_max_ / (1 + b_ * u), 0};
        return BoundedForm{(u + a_) / (u * u + a_ * u + a_ * a_),
                           eta_max_ * (1 + b_ * u) / (1 + b_ * u + c_ * u * u), 0};
      },
      [this](SlipRatio ratio) {
        const double w = ratio.x;
        if (order_ == 1) return BoundedForm{1 / (1 + a_ * w), eta_max_ / (w + b_), 0};
        return BoundedForm{(1 + a_ * w) / (1 + a_ * w + a_ * w * (a_ * w)),
                           eta_max_ * (w + b_) / (w * w + b_ * w + c_), 0};
      });
}

Curvature PadeLaw::curvature(double v, double s) const {
  require_slip(v, s);
  double vv = 0;
  double ss = 0;
  const double scale = std::max(v, s);
  if (v <= s) {
    const double u = slip_ratio(v, s).x;
    if (order_ == 1) {
      vv = a_ / ((u + a_) * (u + a_));
      ss = eta_max_ * b_ * u / ((1 + b_ * u) * (1 + b_ * u));
    } else {
      const double q = u * u + a_ * u + a_ * a_;
      const double p = 1 + b_ * u + c_ * u * u;
      vv = a_ * a_ * (2 * u + a_) / (q * q);
      ss = eta_max_ * c_ * u * u * (2 + b_ * u) / (p * p);
    }
  } else {
    const double w = slip_ratio(s, v).x;
    if (order_ == 1) {
      vv = a_ * w / ((1 + a_ * w) * (1 + a_ * w));
      ss = eta_max_ * b_ / ((w + b_) * (w + b_));
    } else {
      const double q = 1 + a_ * w + a_ * w * (a_ * w);
      const double p = w * w + b_ * w + c_;
      vv = a_ * a_ * (2 + a_ * w) * (w * w) / (q * q);
      ss = eta_max_ * c_ * (2 * w + b_) / (p * p);
    }
  }
  return {vv / scale, -(std::sqrt(vv) * std::sqrt(ss)) / scale, ss / scale};
}

// ---------------------------------------------------------------------------------------------- tanh

namespace {

void require_speeds(double v, double s) {
  if (!(v >= 0 && s >= 0)) throw std::domain_error("friction law: v and s must be numbers >= 0");
}

/// ε log cosh(x/ε), the smoothed |x|.
double smoothed(double x, double epsilon) {
  const double z = x / epsilon;
  if (z < 1e-9) return x / 2 * z;  // the next term is relative z²/6
  // cosh z = 1 + 2 sinh²(z/2), without cancellation for small
  // z; past z = 20, e^{-2z} is below half an ulp of z − log 2.
  if (z < 20) return epsilon * std::log1p(2 * std::sinh(z / 2) * std::sinh(z / 2));
  return x - epsilon * std::numbers::ln2;
}

/// axis/(ε cosh² z) with z = x/ε; the small factors apart, or they would underflow before ε is divided by.
double slope_of_tanh(double axis, double x, double epsilon) {
  const double sech = 1 / std::cosh(x / epsilon);
  return sech * (axis * sech / epsilon);
}

}  // namespace

TanhLaw::TanhLaw(Extent semi_axes, double epsilon)
    : axes_(positive(semi_axes)), epsilon_(positive("velocity scale", epsilon)) {}

Friction TanhLaw::at(double v, double s) const {
  require_speeds(v, s);
  return {axes_.xi * std::tanh(v / epsilon_), axes_.eta * std::tanh(s / epsilon_)};
}

Curvature TanhLaw::curvature(double v, double s) const {
  require_speeds(v, s);
  return {slope_of_tanh(axes_.xi, v, epsilon_), 0.0, slope_of_tanh(axes_.eta, s, epsilon_)};
}

double TanhLaw::potential(double v, double s) const {
  require_speeds(v, s);
  return axes_.xi * smoothed(v, epsilon_) + axes_.eta * smoothed(s, epsilon_);
}

}  // namespace contensou
