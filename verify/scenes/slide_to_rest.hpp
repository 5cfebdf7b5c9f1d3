#pragma once

#include <vector>

#include "patch.hpp"

/// A loaded contact whose sliding speed v and spin speed s = |ω|R nothing but its friction slows down, along
/// a straight line:
///     v̇ = −a ξ(u),   ṡ = −(a/κ) η(u),   u = v/s.
/// Disc: a = μg, κ = I/(mR²), the square of the radius of gyration in units of R. Ball (v of the contact
/// point): a = 7/2 μg, κ = 7/2 · 2/5 r²/R².
namespace verify::answers {

/// How it ends. s u̇ = −a ξ (1 − q/κ) with q(u) = u η/ξ, and q falls strictly from 2/(3 + 2n) at u = 0 over
/// 1/(3 + 2n) at u = 1 to 1/(4 + 2n) at infinity. Hence u tends to one limit from wherever it starts: where q
/// = κ, or, for κ outside, to 0 or infinity; and on the way both speeds go to zero like powers of each other,
/// so that they vanish together.
///
/// That q falls: for u > 1 its two integrals (patch.hpp) depend on 1/u², one rising, one falling. For u <= 1,
/// m = u², let y = ∫sin²θ c^(2n+1)/∫cos²θ c^(2n+1). By parts, dq/dm < 0 if and only if
///     g(m) = (1 − m)y² + (4 + 2n)m y − 1 > 0,   2y' = (1 − y²)/m − ((2n + 2)y − 1)/(1 − m),
/// and where g = 0 this gives y' = y/(1 − m) > 0 and g' >= y(4 + 2n − y) > 0 (n >= −1/2, so that y <= 1). But
/// g = (n + 5/2)m + ... near 0 is positive: no first zero could be reached from above.
struct Limits {
  double spins_only;   ///< κ >= 2/(3 + 2n): u → 0, v ∝ s^((3/2+n)κ)
  double equal;        ///< κ = 1/(3 + 2n): u → 1
  double slides_only;  ///< κ <= 1/(4 + 2n): u → ∞, s ∝ v^(1/((4+2n)κ))
};
Limits limits(double n);
double ratio(const Patch& patch, double u);  ///< q(u), 0 < u < ∞
/// The limit of u, 0 and infinity included.
double final_ratio(const Patch& patch, double kappa);
/// The same in closed form for Hertz pressure where it is at most 1 (κ >= 1/4): the smaller root x = u² of
/// 3/8 x² − (1 − κ/2) x + 1 − 2κ = 0.
double final_ratio_hertz(double kappa);

/// u from `start` when ‖(v, s)‖ has become smaller by e^folds, by GSL.
double late_ratio(const Patch& patch, double kappa, double start, double folds);

/// The motion, by GSL (ode.hpp).
class SlideToRest {
 public:
  struct Point {
    double v, s;    ///< [m/s]
    double slid;    ///< ∫v dt [m]
    double turned;  ///< ∫s dt [m]
    double ratio() const { return v / s; }
  };

  /// v, s >= 0, not both zero.
  SlideToRest(const Patch& patch, double a, double kappa, double v, double s);

  /// When both vanish. From r = ‖(v, s)‖ and ψ = atan u over ℓ = −ln r, in which all is smooth for every u.
  double stopping_time() const { return stop_; }
  double slid() const { return slid_; }      ///< until then
  double turned() const { return turned_; }  ///< until then
  /// At ascending times, 0 <= t < stopping_time(). What is left of the speeds, and so u, has the relative
  /// error accuracy/(1 − t/stop).
  std::vector<Point> at(const std::vector<double>& times) const;
  Point at(double t) const { return at(std::vector<double>{t}).front(); }

 private:
  Patch patch_;
  double a_, kappa_, v_, s_;
  double stop_ = 0, slid_ = 0, turned_ = 0;
};

}  // namespace verify::answers
