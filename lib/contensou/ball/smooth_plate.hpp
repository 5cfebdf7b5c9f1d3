#pragma once

#include <algorithm>
#include <cmath>

#include "contensou/ball/bracketed_newton.hpp"
#include "contensou/ball/plate.hpp"
#include "contensou/law/approximations.hpp"
#include "contensou/law/compiled.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/radial.hpp"
#include "contensou/law/uniform.hpp"

namespace contensou {

/// The friction plate of a law with a convex potential that is homogeneous of degree one and differentiable
/// away from rest: the law is the border, its speeds (v, s) are the border's normal.
///
/// Projection: with the border point x(u) and the normal (u, 1), the point p looked for is where
///   F(u) = (p_t − ξ) − (p_τ − η) u = 0,   F' = −[(1 + u²) f'' + (p_τ − η)],
/// and, for u > 1, with w = 1/u in place of u and the two components exchanged. Of the
/// solutions in the quarter plane none but the projection has a point p outside (the plate holds the box under
/// each of its border points), and p is inside if it lies in the box under any border point. So one bracketed
/// Newton iteration finds the projection or that there is nothing to project. Poles, equator and the seam
/// u = 1 need no special care: u, w and 1 − u are as accurate as doubles are, F is exact to rounding.
///
/// Accuracy: border point and normal belong together to the accuracy of the law; the part of p − x across the
/// normal is at most 4 ulp of the largest of p and the size.
template <FrictionLaw L>
class SmoothPlate {
 public:
  explicit SmoothPlate(L law);

  const L& law() const { return law_; }
  Extent extent() const { return extent_; }
  double support(double v, double s) const { return v == 0 && s == 0 ? 0 : potential(law_, v, s); }
  Friction border(double v, double s) const { return law_.at(v, s); }
  PlateRay ray(double t, double tau) const;
  PlateProjection project(Meridian p, double size) const;
  double curvature_radius(const PlateProjection& q) const;

 private:
  /// Which half of the border, and its variable x in [0, 1]: u = v/s (inner) or w = s/v (outer).
  struct Normal {
    bool inner;
    double x;
    Meridian direction() const { return inner ? Meridian{x, 1} : Meridian{1, x}; }
  };
  Friction at(Normal n) const { return n.inner ? law_.at(n.x, 1) : law_.at(1, n.x); }
  /// f''(u) inside, u³f''(u) outside: how fast the border turns.
  double second(Normal n) const {
    return n.inner ? law_.curvature(n.x, 1).vv : law_.curvature(1, n.x).ss;
  }
  PlateProjection finish(Meridian p, double size, Meridian scaled, double scaled_size, Normal normal,
                         int iterations) const;

  L law_;
  Extent extent_;
  Friction seam_;        ///< at u = 1
  double second_pole_;   ///< f''(0)
  double second_seam_;   ///< f''(1)
  double second_equator_;  ///< u³ f''(u) at u = ∞
};

namespace detail {

inline PlateProjection inside_plate(Meridian p, int iterations) {
  return {p, {0, 0}, 0, 0, iterations, true};
}

/// Where h(x), known with its derivative −fall at 0 and at 1, is zero: the inverse function's Hermite cubic,
/// or the secant where that is no use. h0 > 0 >= h1. In (0, 1], with the relative accuracy of h0 for small h0.
inline double guess_root(double h0, double fall0, double h1, double fall1) {
  const double drop = h0 - h1;
  const double q = h0 / drop;  // how far down, 0 to 1
  double x = q;
  if (fall0 > 0 && fall1 > 0 && std::isfinite(fall1)) {
    const double a = drop / fall0;  // dx/dq at both ends
    const double b = drop / fall1;
    const double cubic = q * (a + q * (3 - 2 * a - b + q * (a + b - 2)));
    if (cubic > 0 && cubic <= 1) x = cubic;
  }
  return x;
}

}  // namespace detail

template <FrictionLaw L>
SmoothPlate<L>::SmoothPlate(L law)
    : law_(std::move(law)),
      extent_(law_.extent()),
      seam_(law_.at(1, 1)),
      second_pole_(law_.curvature(0, 1).vv),
      second_seam_(law_.curvature(1, 1).vv),
      second_equator_(law_.curvature(1, 0).ss) {}

template <FrictionLaw L>
PlateRay SmoothPlate<L>::ray(double t, double tau) const {
  if (t == 0) return {tau / extent_.eta, {0, 1}, 0};
  if (tau == 0) return {t / extent_.xi, {1, 0}, 0};
  int exponent = 0;
  std::frexp(std::max(t, tau), &exponent);
  const double a = std::ldexp(t, -exponent);
  const double b = std::ldexp(tau, -exponent);
  // h = a η − b ξ falls with u from a η_max to −b ξ_max.
  const double at_seam = a * seam_.eta - b * seam_.xi;
  const bool inner = at_seam <= 0;
  const double guess =
      inner ? detail::guess_root(a * extent_.eta, second_pole_ * b, at_seam, second_seam_ * (a + b))
            : detail::guess_root(b * extent_.xi, second_equator_ * a, -at_seam, second_seam_ * (a + b));
  Friction x{};
  const NewtonEnd end = bracketed_newton(guess, [&](double ratio) {
    const Normal normal{inner, ratio};
    x = at(normal);
    const double h = a * x.eta - b * x.xi;
    return NewtonStep{inner ? h : -h, second(normal) * (inner ? b + a * ratio : a + b * ratio), false};
  });
  const Normal normal{inner, end.x};
  x = at(normal);
  return {a * x.eta > b * x.xi || x.eta == 0 ? t / x.xi : tau / x.eta, normal.direction(),
          end.iterations + 1};
}

template <FrictionLaw L>
PlateProjection SmoothPlate<L>::project(Meridian p, double size) const {
  // A point within the two chords pole – seam – equator is inside.
  const auto chords = [&](double t, double tau) {
    return t <= seam_.xi ? tau <= extent_.eta - (extent_.eta - seam_.eta) / seam_.xi * t
                         : tau <= seam_.eta / (extent_.xi - seam_.xi) * (extent_.xi - t);
  };
  if (chords(p.t / size, p.tau / size)) return detail::inside_plate(p, 0);

  // Outside or near the border. Far from the ends of the range nothing is scaled.
  constexpr double large = 0x1p500;
  const double largest = std::max(p.t, p.tau);
  double a = p.t;
  double b = p.tau;
  double m = size;
  if (!(largest < large && size > 1 / large)) {
    int exponent = 0;
    std::frexp(largest, &exponent);
    a = std::ldexp(a, -exponent);
    b = std::ldexp(b, -exponent);
    m = std::ldexp(m, -exponent);
  }
  if (p.t == 0) return b <= m * extent_.eta ? detail::inside_plate(p, 0) : finish(p, size, {a, b}, m, {true, 0}, 0);
  if (p.tau == 0) return a <= m * extent_.xi ? detail::inside_plate(p, 0) : finish(p, size, {a, b}, m, {false, 0}, 0);

  const double seam_t = a - m * seam_.xi;
  const double seam_tau = b - m * seam_.eta;
  const bool inner = seam_t <= seam_tau;
  const double turn = 2 * m * second_seam_;
  const double guess =
      inner ? detail::guess_root(a, m * second_pole_ + (b - m * extent_.eta), seam_t - seam_tau, turn + seam_tau)
            : detail::guess_root(b, m * second_equator_ + (a - m * extent_.xi), seam_tau - seam_t, turn + seam_t);
  // So near to a pole or the equator that u (or w) is as good as zero: p_t itself is, beside p_τ.
  constexpr double negligible = 0x1p-1000;
  if (guess < negligible) return finish(p, size, {a, b}, m, {inner, guess}, 0);
  const NewtonEnd end = bracketed_newton(guess, [&](double ratio) {
    const Normal normal{inner, ratio};
    const Friction x = at(normal);
    const double t = a - m * x.xi;
    const double tau = b - m * x.eta;
    if (t <= 0 && tau <= 0) return NewtonStep{0, 0, true};
    const double along = inner ? tau : t;
    const double across = inner ? t : tau;
    return NewtonStep{across - along * ratio, m * (1 + ratio * ratio) * second(normal) + along, false};
  });
  if (end.stopped) return detail::inside_plate(p, end.iterations);
  return finish(p, size, {a, b}, m, {inner, end.x}, end.iterations);
}

/// The projection whose normal is known; `scaled` and `scaled_size` are p and size over a common power of two.
template <FrictionLaw L>
PlateProjection SmoothPlate<L>::finish(Meridian p, double size, Meridian scaled, double scaled_size,
                                       Normal normal, int iterations) const {
  const Friction x = at(normal);
  const double t = scaled.t - scaled_size * x.xi;
  const double tau = scaled.tau - scaled_size * x.eta;
  const double along = normal.inner ? tau : t;
  const double across = normal.inner ? t : tau;
  const double length = std::sqrt(1 + normal.x * normal.x);
  const double distance = (along + across * normal.x) / length;
  if (!(distance > 0)) return detail::inside_plate(p, iterations + 1);  // on the border, but for rounding
  const double back = scaled.t >= scaled.tau ? p.t / scaled.t : p.tau / scaled.tau;
  return {{size * x.xi, size * x.eta}, normal.direction(), distance * back,
          std::abs(across - along * normal.x) / length * back, iterations + 1, false};
}

template <FrictionLaw L>
double SmoothPlate<L>::curvature_radius(const PlateProjection& q) const {
  const bool inner = q.direction.tau == 1;
  const double x = inner ? q.direction.t : q.direction.tau;
  const double square = 1 + x * x;
  return second({inner, x}) * square * std::sqrt(square);
}

extern template class SmoothPlate<UniformLaw>;
extern template class SmoothPlate<HertzLaw>;
extern template class SmoothPlate<CompiledLaw>;
extern template class SmoothPlate<RadialLaw>;
extern template class SmoothPlate<EllipsoidLaw>;

}  // namespace contensou
