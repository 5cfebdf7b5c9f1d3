#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "contensou/law/friction_law.hpp"

namespace known_motions {

/// A permanently loaded contact whose sliding speed v and spin speed s = |ω|R are slowed down by nothing but
/// their friction,
///     v̇ = −a ξ(u),   ṡ = −b η(u),   u = v/s,
/// along a straight line and about a fixed axis: of a disc a = μg, b = μg mR²/I; of a ball a = 7/2 μg, b =
/// μg mR²/I. The law is homogeneous of degree one.
///
/// With κ = b/a and D(u) = ξ − κuη the ratio obeys su̇ = −aD, and d ln s/du = κη/D. D has one zero u* that
/// attracts u; both speeds vanish together, there. With w = u − u* and D = wC(u) the pole is taken out,
///     s = s_0 (w/w_0)^p exp(G(u)),  p = κη/C at u*,   G = ∫ (κη/C − p)/w du from u_0,
/// and in y = (w/w_0)^p, from 1 down to 0, time and path are integrals of bounded functions,
///     dt = −(s_0/ap) e^G/C dy.
/// All by quadrature: Gauss's for G, tanh-sinh (powers of y at its end) for time and path.
///
/// u* = 0 where D'(0) >= 0, that is, for the pressure (1 − ρ²/R²)ⁿ, κ <= 3/2 + n; for κ >= 4 + 2n it is
/// infinite and the motion ends without spin, which is not in here.
template <contensou::FrictionLaw Law>
class SlideAndSpin {
 public:
  struct Point {
    double t;
    double v;
    double s;
    double slid;    ///< ∫v dt
    double turned;  ///< ∫s dt
  };

  /// v_0, s_0 > 0; a, b > 0. Throws std::invalid_argument if u* is infinite.
  SlideAndSpin(const Law& law, double a, double b, double v, double s)
      : law_(law), a_(a), kappa_(b / a), s_(s), limit_(find_limit()), w_(v / s - limit_) {
    const auto [xi, eta] = law_.at(limit_, 1);
    power_ = kappa_ * eta / slope(limit_);
    on_limit_ = std::abs(w_) <= on_limit * (1 + limit_);
    end_ = on_limit_ ? steady_end() : point(0);
  }

  double final_ratio() const { return limit_; }  ///< u*
  double stopping_time() const { return end_.t; }

  Point at(double t) const {
    const double end = end_.t;
    if (t >= end) return end_;
    if (on_limit_) {  // both speeds fall linearly
      const double left = 1 - t / end;
      const double turned = (1 - left * left) * end_.turned;
      return {t, limit_ * left * s_, left * s_, limit_ * turned, turned};
    }
    if (t <= 0) return point(1);
    // y falls nearly linearly: a few of Newton's steps
    const auto late = [&](double y) { return std::make_pair(time(y) - t, -pace(y)); };
    constexpr int bits = 46;
    std::uintmax_t iterations = 30;
    const double y =
        boost::math::tools::newton_raphson_iterate(late, 1 - t / end, 0.0, 1.0, bits, iterations);
    Point result = point(y);
    result.t = t;
    return result;
  }

 private:
  // So near to u* the ratio is taken to be constant.
  static constexpr double on_limit = 1e-13;

  double deviation(double u) const {
    const auto [xi, eta] = law_.at(u, 1);
    return xi - kappa_ * u * eta;
  }
  /// D'(u), with ξ' = f'', η' = −uf''.
  double slope(double u) const {
    return law_.curvature(u, 1).vv * (1 + kappa_ * u * u) - kappa_ * law_.at(u, 1).eta;
  }
  double find_limit() const {
    if (slope(0) >= 0) return 0;
    double high = 1;
    while (deviation(high) <= 0) {
      high *= 2;
      if (high > 1e6) throw std::invalid_argument("slide and spin: the motion ends without spin");
    }
    std::uintmax_t iterations = 200;
    // not from 0: there D is zero, too
    const auto [a, b] =
        boost::math::tools::toms748_solve([this](double u) { return deviation(u); }, 1e-6, high,
                                          boost::math::tools::eps_tolerance<double>(53), iterations);
    return (a + b) / 2;
  }

  /// Where |w| is at most this, all is smooth, u = 1 being twice as far, and D/w must not be formed by
  /// division.
  double vicinity() const { return std::min(0.1, std::abs(1 - limit_) / 2); }
  /// C = D/w: near u* as the mean of D', which does not cancel.
  double divided(double u) const {
    const double w = u - limit_;
    if (std::abs(w) > vicinity()) return deviation(u) / w;
    return boost::math::quadrature::gauss<double, 10>::integrate(
        [&](double part) { return slope(limit_ + part * w); }, 0.0, 1.0);
  }
  double growth_rate(double u) const {
    return (kappa_ * law_.at(u, 1).eta / divided(u) - power_) / (u - limit_);
  }
  /// ∫ growth_rate du on one side of u = 1, where it may be like (u − 1)² ln|u − 1|: in z = ∛(u − 1) that is
  /// smooth. Panels double in length towards large u.
  double far(double from, double to) const {
    const double a = std::cbrt(from - 1);
    const double b = std::cbrt(to - 1);
    if (std::abs(a) > std::abs(b)) return -far(to, from);
    double sum = 0;
    for (double size = std::abs(a); size < std::abs(b);) {
      const double next = std::min(std::max(1.0, 2 * size), std::abs(b));
      const double sign = std::copysign(1, b);
      sum += boost::math::quadrature::gauss<double, 30>::integrate(
          [this](double z) { return 3 * z * z * growth_rate(1 + z * z * z); }, sign * size, sign * next);
      size = next;
    }
    return sum;
  }
  double growth(double u) const {  ///< G
    const double u0 = limit_ + w_;
    const double border = limit_ + std::copysign(std::min(vicinity(), std::abs(w_)), w_);
    const double end = std::abs(u - limit_) > std::abs(border - limit_) ? u : border;
    const bool across = (end - 1) * (u0 - 1) < 0;
    const double outside = across ? far(u0, 1) + far(1, end) : far(u0, end);
    if (end == u) return outside;
    return outside + boost::math::quadrature::gauss<double, 20>::integrate(
                         [this](double x) { return growth_rate(x); }, border, u);
  }
  double ratio(double y) const { return limit_ + w_ * std::pow(y, 1 / power_); }

  Point steady_end() const {
    const double t = s_ / (kappa_ * a_ * law_.at(limit_, 1).eta);
    return {t, 0, 0, limit_ * s_ * t / 2, s_ * t / 2};
  }

  /// ∫ f(y) dy from y to 1, split at u = 1.
  template <class F>
  double integral(const F& f, double y) const {
    boost::math::quadrature::tanh_sinh<double> rule;
    constexpr double tolerance = 1e-13;
    const auto piece = [&](double from, double to) {
      return to > from ? rule.integrate(f, from, to, tolerance) : 0.0;
    };
    const double seam = std::pow(std::max(0.0, (1 - limit_) / w_), power_);
    return seam > y && seam < 1 ? piece(y, seam) + piece(seam, 1) : piece(y, 1);
  }
  double speed(double y) const { return s_ * y * std::exp(growth(ratio(y))); }
  /// −dt/dy
  double pace(double y) const {
    const double u = ratio(y);
    return s_ / (a_ * power_) * std::exp(growth(u)) / divided(u);
  }
  double time(double y) const {
    return integral([this](double x) { return pace(x); }, y);
  }
  Point point(double y) const {
    const double s = speed(y);
    return {time(y), ratio(y) * s, s, integral([this](double x) { return ratio(x) * speed(x) * pace(x); }, y),
            integral([this](double x) { return speed(x) * pace(x); }, y)};
  }

  Law law_;
  double a_;
  double kappa_;
  double s_;
  double limit_;
  double w_;  ///< u − u* at the start
  double power_ = 0;
  bool on_limit_ = false;
  Point end_{};
};

}  // namespace known_motions
