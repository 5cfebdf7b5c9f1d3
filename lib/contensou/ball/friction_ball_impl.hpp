#pragma once

#include <algorithm>
#include <cmath>

#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/polar.hpp"

namespace contensou::detail {

/// In error messages.
inline constexpr const char* ball_name = "friction ball";

/// A vector in cylinder coordinates.
struct Cylindrical {
  Meridian meridian;
  double e1, e2;  ///< unit vector of the tangential part; (1, 0) where that is zero
  double sign;    ///< of the spin part

  Eigen::Vector3d vector(Meridian m) const { return {m.t * e1, m.t * e2, sign * m.tau}; }
};

/// Where a plate can be left alone: no sum of two components overflows, no product with one falls short.
constexpr double large_force = 0x1p1000;
constexpr double small_force = 0x1p-600;
inline bool comfortable(Meridian p) {
  const double largest = std::max(p.t, p.tau);
  return largest < large_force && largest > small_force;
}

/// The exponent that brings the larger component, which is not zero, into [½, 1).
int exponent_of(Meridian p);

/// The projection at the ends of the range, by that of p and size over a common power of two.
template <FrictionPlate P>
PlateProjection project_scaled(const P& plate, Meridian p, double size) {
  const int exponent = std::max(p.t, p.tau) >= large_force ? 64 : -600;
  const double scaled_size = std::ldexp(size, -exponent);
  PlateProjection q = plate.project({std::ldexp(p.t, -exponent), std::ldexp(p.tau, -exponent)}, scaled_size);
  q.point = {std::ldexp(q.point.t, exponent), std::ldexp(q.point.tau, exponent)};
  q.distance = std::ldexp(q.distance, exponent);
  q.residual = std::ldexp(q.residual, exponent);
  // From so far away only the direction counts, and the size has fallen short of its digits.
  constexpr double subnormal = 0x1p-1022;
  if (scaled_size < subnormal && exponent > 0 && !q.inside) {
    const Friction x = plate.border(q.direction.t, q.direction.tau);
    q.point = {size * x.xi, size * x.eta};
  }
  return q;
}

/// Throws std::domain_error for a vector that is not finite.
Cylindrical cylindrical(const Eigen::Vector3d& x);
[[noreturn]] void no_direction();

inline Meridian unit(Meridian direction) {
  const double length = std::sqrt(direction.t * direction.t + direction.tau * direction.tau);
  return {direction.t / length, direction.tau / length};
}

/// D = along tᵀt + across φφᵀ with the meridian's unit tangent t and the unit vector φ around the axis.
Eigen::Matrix3d projection_jacobian(const Cylindrical& frame, Meridian unit_normal, double along,
                                    double across);

}  // namespace contensou::detail

namespace contensou {

template <FrictionPlate P>
double FrictionBall<P>::support(double size, const SlipVelocity& gamma) const {
  detail::require_size(size, detail::ball_name);
  const Meridian direction = detail::cylindrical(gamma).meridian;
  return size * plate_.support(direction.t, direction.tau);
}

template <FrictionPlate P>
FrictionForce FrictionBall<P>::boundary_point(double size, const Eigen::Vector3d& normal) const {
  detail::require_size(size, detail::ball_name);
  const detail::Cylindrical frame = detail::cylindrical(normal);
  if (frame.meridian.t == 0 && frame.meridian.tau == 0) detail::no_direction();
  const Friction border = plate_.border(frame.meridian.t, frame.meridian.tau);
  return frame.vector({size * border.xi, size * border.eta});
}

template <FrictionPlate P>
double FrictionBall<P>::gauge(const FrictionForce& force) const {
  const Meridian p = detail::cylindrical(force).meridian;
  if (p.t == 0 && p.tau == 0) return 0;
  if (detail::comfortable(p)) return plate_.ray(p.t, p.tau).gauge;
  const int exponent = detail::exponent_of(p);
  return std::ldexp(plate_.ray(std::ldexp(p.t, -exponent), std::ldexp(p.tau, -exponent)).gauge, exponent);
}

template <FrictionPlate P>
bool FrictionBall<P>::contains(const FrictionForce& force, double size) const {
  return project(force, size).inside;
}

template <FrictionPlate P>
bool FrictionBall<P>::on_boundary(const FrictionForce& force, double size, double tolerance) const {
  detail::require_size(size, detail::ball_name);
  return std::abs(gauge(force) - size) <= tolerance * size;
}

template <FrictionPlate P>
Eigen::Vector3d FrictionBall<P>::normal(const FrictionForce& force) const {
  const detail::Cylindrical frame = detail::cylindrical(force);
  const Meridian p = frame.meridian;
  if (p.t == 0 && p.tau == 0) detail::no_direction();
  const int exponent = detail::comfortable(p) ? 0 : detail::exponent_of(p);
  const PlateRay ray = plate_.ray(std::ldexp(p.t, -exponent), std::ldexp(p.tau, -exponent));
  return frame.vector(detail::unit(ray.direction));
}

template <FrictionPlate P>
Projection<3> FrictionBall<P>::project(const FrictionForce& force, double size) const {
  detail::require_size(size, detail::ball_name);
  const detail::Cylindrical frame = detail::cylindrical(force);
  const Meridian p = frame.meridian;
  if (p.t == 0 && p.tau == 0) return {force, Eigen::Vector3d::Zero(), 0, 0, 0, true};
  if (size == 0) {
    const int exponent = detail::exponent_of(p);
    const Meridian direction{std::ldexp(p.t, -exponent), std::ldexp(p.tau, -exponent)};
    return {
        Eigen::Vector3d::Zero(), frame.vector(detail::unit(direction)), std::hypot(p.t, p.tau), 0, 0, false};
  }
  const PlateProjection q =
      detail::comfortable(p) ? plate_.project(p, size) : detail::project_scaled(plate_, p, size);
  if (q.inside) return {force, Eigen::Vector3d::Zero(), 0, 0, q.iterations, true};
  return {frame.vector(q.point),
          frame.vector(detail::unit(q.direction)),
          q.distance,
          q.residual,
          q.iterations,
          false};
}

template <FrictionPlate P>
ProjectionDerivative<3> FrictionBall<P>::derivative(const Projection<3>& q, const FrictionForce& force,
                                                    double size) const {
  if (q.inside) return {Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  const detail::Cylindrical frame = detail::cylindrical(force);
  const Meridian n{q.normal.head<2>().norm(), std::abs(q.normal.z())};
  const Meridian direction = n.t <= n.tau ? Meridian{n.t / n.tau, 1} : Meridian{1, n.tau / n.t};
  if (size == 0) {
    return {Eigen::Matrix3d::Zero(), boundary_point(1, q.normal)};
  }
  const Meridian point = detail::cylindrical(q.point).meridian;
  const double radius =
      size * plate_.curvature_radius({point, direction, q.distance, q.residual, q.iterations, false});
  // The radius may have left the range of doubles; on the border the limit is 1 whatever it is.
  const double along = q.distance == 0 ? 1 : 1 / (1 + q.distance / radius);
  const double across = frame.meridian.t > 0 ? point.t / frame.meridian.t : along;
  ProjectionDerivative<3> d;
  d.force = detail::projection_jacobian(frame, n, along, across);
  d.size = (q.point - d.force * q.point) / size;
  return d;
}

}  // namespace contensou
