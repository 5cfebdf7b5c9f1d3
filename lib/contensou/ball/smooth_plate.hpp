#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "contensou/ball/border_nodes.hpp"
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
/// and, for u > 1, with w = 1/u in place of u and the two components exchanged. Of the solutions in the
/// quarter plane none but the projection has a point p outside (the plate holds the box under each of its
/// border points), and p is inside if it lies in the box under any border point. So one bracketed iteration
/// finds the projection or that there is nothing to project. Stored border points give the bracket and a
/// start so good that few evaluations of the law follow (counted by verify_ball: ball_iterations.tsv); it
/// ends when F is as good as its rounding. Poles, equator and the seam u = 1 need no special care: u, w and
/// 1 − u are as accurate as doubles are.
///
/// Accuracy: border point and normal belong together to the accuracy of the law; the part of p − x across the
/// normal is at most 4 ulp of the largest of p and the size (largest found by verify_ball: ball.tsv).
template <FrictionLaw L>
class SmoothPlate {
 public:
  /// Evaluates the law some 130 times.
  explicit SmoothPlate(L law);

  const L& law() const { return law_; }
  Extent extent() const { return law_.extent(); }
  double support(double v, double s) const { return v == 0 && s == 0 ? 0 : potential(law_, v, s); }
  Friction border(double v, double s) const { return law_.at(v, s); }
  PlateRay ray(double t, double tau) const;
  PlateProjection project(Meridian p, double size) const;
  double curvature_radius(const PlateProjection& q) const;

  /// Whether p, not zero, is beyond the tangent of one of the two stored border points next to its ray: then
  /// it is outside. Cheap, and false for few points outside, all within some 1e-3 of the border.
  bool beyond_tangents(Meridian p, double size) const;
  /// The border and its derivative where the normal is (x, 1), `inner`, or (1, x), x in [0, 1], interpolated
  /// between stored points: for a fraction of the law's price, and to some 1e-8 (1e-6 the derivative).
  BorderNode interpolated(bool inner, double x) const { return (inner ? inner_ : outer_).interpolated(x); }

 private:
  // F and what else is found zero is taken to be so at this part of its largest term: the rounding of
  // three terms.
  static constexpr double rounding = 0x1p-51;
  // So near to a pole or the equator everything is linear, and the start is the root.
  static constexpr double linear = 0x1p-300;

  /// A point of the half that goes with `inner`: components along the normal's 1 and across.
  BorderNode at(bool inner, double x) const {
    const Friction b = inner ? law_.at(x, 1) : law_.at(1, x);
    return inner ? BorderNode{x, b.xi, b.eta, 0} : BorderNode{x, b.eta, b.xi, 0};
  }
  /// f''(u) inside, u³f''(u) outside: how fast the border turns.
  double second(bool inner, double x) const {
    return inner ? law_.curvature(x, 1).vv : law_.curvature(1, x).ss;
  }
  BorderNodes nodes(bool inner) const {
    return BorderNodes([this, inner](double x) {
      BorderNode node = at(inner, x);
      node.second = second(inner, x);
      return node;
    });
  }
  static Meridian direction(bool inner, double x) { return inner ? Meridian{x, 1} : Meridian{1, x}; }
  static PlateProjection finish(Meridian p, double size, bool inner, const BorderNode& border, double fall,
                                int iterations);

  L law_;
  BorderNodes inner_;
  BorderNodes outer_;
};

namespace detail {

inline PlateProjection inside_plate(Meridian p, int iterations) {
  return {p, {0, 0}, 0, 0, iterations, true};
}

}  // namespace detail

template <FrictionLaw L>
SmoothPlate<L>::SmoothPlate(L law) : law_(std::move(law)), inner_(nodes(true)), outer_(nodes(false)) {}

template <FrictionLaw L>
PlateRay SmoothPlate<L>::ray(double t, double tau) const {
  if (t == 0) return {tau / extent().eta, {0, 1}, 0};
  if (tau == 0) return {t / extent().xi, {1, 0}, 0};
  // t η − τ ξ falls with u from t η_max to −τ ξ_max.
  const BorderNode& seam = inner_.back();
  const bool inner = t * seam.along <= tau * seam.across;
  const BorderNodes& nodes = inner ? inner_ : outer_;
  const double a = inner ? t : tau;
  const double b = inner ? tau : t;
  const auto value = [=](const BorderNode& n) { return a * n.along - b * n.across; };
  const auto fall = [=](const BorderNode& n) { return n.second * (b + a * n.x); };
  const auto [left, right] = nodes.cell([&](const BorderNode& n) { return value(n) > 0; });
  const Start start =
      start_in_cell(left.x, right.x - left.x, value(left), fall(left), value(right), fall(right));
  SecantSlope slope(start.fall);
  BorderNode border{};
  const NewtonEnd end = bracketed_newton({left.x, right.x}, start.x, [&](double x) {
    border = at(inner, x);
    const double h = value(border);
    if (std::abs(h) <= rounding * a * border.along || x < linear) return NewtonStep{h, 0, true};
    return NewtonStep{h, slope.at(x, h), false};
  });
  // The gauge is the largest of p·n/support(n) over all normals n: an error of n counts with its square.
  const double gauge = (a * border.x + b) / (border.across * border.x + border.along);
  return {gauge, direction(inner, border.x), end.iterations};
}

template <FrictionLaw L>
bool SmoothPlate<L>::beyond_tangents(Meridian p, double size) const {
  const BorderNode& seam = inner_.back();
  const bool inner = p.t * seam.along <= p.tau * seam.across;
  const double a = inner ? p.t : p.tau;
  const double b = inner ? p.tau : p.t;
  const auto [left, right] =
      (inner ? inner_ : outer_).cell([=](const BorderNode& n) { return a * n.along - b * n.across > 0; });
  const auto beyond = [=](const BorderNode& n) {
    return (a - size * n.across) * n.x + (b - size * n.along) > 0;
  };
  return beyond(left) || beyond(right);
}

template <FrictionLaw L>
PlateProjection SmoothPlate<L>::project(Meridian p, double size) const {
  const BorderNode& seam = inner_.back();
  const double seam_t = p.t - size * seam.across;
  const double seam_tau = p.tau - size * seam.along;
  if (seam_t <= 0 && seam_tau <= 0) return detail::inside_plate(p, 0);
  const bool inner = seam_t <= seam_tau;
  const BorderNodes& nodes = inner ? inner_ : outer_;
  const double a = inner ? p.t : p.tau;
  const double b = inner ? p.tau : p.t;
  if (a == 0) return finish(p, size, inner, nodes.front(), 0, 0);

  const auto value = [=](const BorderNode& n) { return a - size * n.across - (b - size * n.along) * n.x; };
  const auto fall = [=](const BorderNode& n) {
    return size * (1 + n.x * n.x) * n.second + (b - size * n.along);
  };
  double out_of_box = 1;  // of the node least far exceeded
  const auto [left, right] = nodes.cell([&](const BorderNode& n) {
    const double across = a - size * n.across;
    const double along = b - size * n.along;
    out_of_box = std::min(out_of_box, std::max(across, along));
    return across - along * n.x > 0;
  });
  if (out_of_box <= 0) return detail::inside_plate(p, 0);
  // Under the chord of the cell, and beside neither of its ends.
  const double right_of_left = a - size * left.across;
  const double above_right = b - size * right.along;
  if (b <= size * left.along && a <= size * right.across &&
      right_of_left * (left.along - right.along) + above_right * (right.across - left.across) <=
          size * (right.across - left.across) * (left.along - right.along)) {
    return detail::inside_plate(p, 0);
  }
  const Start start =
      start_in_cell(left.x, right.x - left.x, value(left), fall(left), value(right), fall(right));
  SecantSlope slope(start.fall);
  BorderNode border{};
  const double largest = rounding * std::max(b, size);
  const NewtonEnd end = bracketed_newton({left.x, right.x}, start.x, [&](double x) {
    border = at(inner, x);
    const double f = value(border);
    if (std::abs(f) <= std::max(rounding * a, largest * x) || x < linear) return NewtonStep{f, 0, true};
    if (a <= size * border.across && b <= size * border.along) return NewtonStep{f, 0, true};
    return NewtonStep{f, slope.at(x, f), false};
  });
  return finish(p, size, inner, border, slope.last(), end.iterations);
}

/// The projection whose border point is known, or that there is nothing to project. What F still is there,
/// mostly below what the next double x would change, is made up for along the tangent; `fall` is −F'.
template <FrictionLaw L>
PlateProjection SmoothPlate<L>::finish(Meridian p, double size, bool inner, const BorderNode& border,
                                       double fall, int iterations) {
  const double square = 1 + border.x * border.x;
  double across = (inner ? p.t : p.tau) - size * border.across;
  double along = (inner ? p.tau : p.t) - size * border.along;
  // F' = −[size (1 + x²) f'' + along]: the first term is the share of F that the border point takes.
  const double share = fall > along ? (fall - along) / fall : 0;
  const double whole_step = share * (across - along * border.x) / square;
  // From afar F is all rounding, and no ulp of x moves the border so far.
  constexpr double some_ulp = 0x1p-48;
  const double step = std::abs(whole_step) <= some_ulp * size ? whole_step : 0;
  across -= step;
  along += step * border.x;
  const double length = std::sqrt(square);
  const double distance = (along + across * border.x) / length;
  if (!(distance > 0)) return detail::inside_plate(p, iterations);
  const double residual = std::abs(across - along * border.x) / length;
  const double point_across = size * border.across + step;
  const double point_along = size * border.along - step * border.x;
  const Meridian point = inner ? Meridian{point_across, point_along} : Meridian{point_along, point_across};
  return {point, direction(inner, border.x), distance, residual, iterations, false};
}

template <FrictionLaw L>
double SmoothPlate<L>::curvature_radius(const PlateProjection& q) const {
  const bool inner = q.direction.tau == 1;
  const double x = inner ? q.direction.t : q.direction.tau;
  const double square = 1 + x * x;
  return second(inner, x) * square * std::sqrt(square);
}

extern template class SmoothPlate<UniformLaw>;
extern template class SmoothPlate<HertzLaw>;
extern template class SmoothPlate<CompiledLaw>;
extern template class SmoothPlate<RadialLaw>;
extern template class SmoothPlate<EllipsoidLaw>;

}  // namespace contensou
