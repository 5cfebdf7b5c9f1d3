#pragma once

#include <concepts>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// A point or a direction of the quarter plane (‖λ_T‖, |λ_τ|), both >= 0, in which a friction plate lives.
struct Meridian {
  double t;
  double tau;
};

/// The Euclidean projection of a point onto a plate of a given size μλ_N.
struct PlateProjection {
  Meridian point;      ///< nearest point of the plate; the point itself where it is inside
  Meridian direction;  ///< of the outward normal at `point`, its larger component 1; {0, 0} inside
  double distance;     ///< from the plate; 0 inside
  double residual;     ///< part of (given point − `point`) that is not along the normal; 0 inside
  int iterations;      ///< border points evaluated
  bool inside;
};

/// Where the ray from the origin through a point leaves the plate of size 1.
struct PlateRay {
  double gauge;        ///< the size of plate that just reaches the point
  Meridian direction;  ///< of an outward normal there, its larger component 1
  int iterations;      ///< border points evaluated
};

/// A friction plate P_F(λ_N), LG03 (2.18), (3.19): the admissible (‖λ_T‖, |λ_τ|), in units of the size μλ_N.
/// Turned about the λ_τ axis and mirrored in the tangent plane it is the friction ball (friction_ball.hpp),
/// which is where arguments are checked and brought far from the ends of the range of doubles; a plate takes
/// them to be >= 0, the larger component of a point between 2^-600 and 2^1000.
///
///   extent()           semi-axes
///   support(v, s)      max of v ξ + s η over the plate: Φ/(μλ_N) for a plate that is convex
///   border(v, s)       a border point with outward normal (v, s), not both zero
///   ray(t, tau)        gauge and normal along a ray, (t, tau) not both zero
///   project(p, size)   Euclidean projection, size > 0
///   curvature_radius(q)  radius of curvature of the border of the plate of size 1 at the projection q, which
///                      is not inside: 0 in a corner, ∞ where the border is straight
template <class P>
concept FrictionPlate = requires(const P& plate, double v, double s, Meridian p, const PlateProjection& q) {
  { plate.extent() } -> std::same_as<Extent>;
  { plate.support(v, s) } -> std::same_as<double>;
  { plate.border(v, s) } -> std::same_as<Friction>;
  { plate.ray(v, s) } -> std::same_as<PlateRay>;
  { plate.project(p, s) } -> std::same_as<PlateProjection>;
  { plate.curvature_radius(q) } -> std::same_as<double>;
};

}  // namespace contensou
