#pragma once

#include <Eigen/Core>
#include <utility>

#include "contensou/ball/friction_domain.hpp"
#include "contensou/ball/plate.hpp"
#include "contensou/law/force.hpp"

namespace contensou {

/// The friction ball B_F(λ_N), LG03 (2.19): a friction plate turned about the λ_τ axis, mirrored in the
/// tangent plane, of size μλ_N. Forces are λ_F = (λ_T1, λ_T2, λ_τ) [N], velocities γ_F = (γ_T1, γ_T2, γ_τ)
/// [m/s], LG03 (2.17). Friction is −γ_F ∈ N_B(λ_F), LG03 (2.20); every simulator's question about it is here.
///
/// A FrictionDomain: errors as stated there. All results have the symmetry of the ball to the bit (signs, and
/// exchange of the two tangential components), and forces may be of any finite size, from subnormal to the
/// largest double.
template <FrictionPlate P>
class FrictionBall {
 public:
  static constexpr int dimension = 3;

  explicit FrictionBall(P plate) : plate_(std::move(plate)) {}

  const P& plate() const { return plate_; }

  /// max of λ·γ over the ball [W]: Φ(γ) for a convex ball.
  double support(double size, const SlipVelocity& gamma) const;
  /// The point of the border with outward normal along `normal` (any length, not zero, else
  /// std::domain_error): −λ_F of the slip velocity `normal`. Where the border has a flat there, the point of
  /// least norm.
  FrictionForce boundary_point(double size, const Eigen::Vector3d& normal) const;

  /// The size μλ_N of the ball that just reaches the force; infinite where none does (a torque against a
  /// disk).
  double gauge(const FrictionForce& force) const;
  /// Whether the force is in the ball: the contact can stick under it.
  bool contains(const FrictionForce& force, double size) const;
  /// The slip criterion λ_F ∈ ∂B_F: whether gauge(force) = size to a relative `tolerance` >= 0.
  bool on_boundary(const FrictionForce& force, double size, double tolerance = 1e-12) const;
  /// A unit outward normal at the point of the border on the ray through the force (not zero, else
  /// std::domain_error): the direction of −γ_F in which the contact slips under it. The only one, but where
  /// the border has an edge.
  Eigen::Vector3d normal(const FrictionForce& force) const;

  /// The nearest point of the ball: prox_B(force), LG03 (4.12).
  Projection<3> project(const FrictionForce& force, double size) const;
  /// The generalised Jacobian of the projection q = project(force, size): along the meridian ρ/(ρ + distance)
  /// with the border's radius of curvature ρ, across it ‖q_T‖/‖λ_T‖, zero along the normal; the identity
  /// inside.
  ProjectionDerivative<3> derivative(const Projection<3>& q, const FrictionForce& force, double size) const;

 private:
  P plate_;
};

}  // namespace contensou

#include "contensou/ball/friction_ball_impl.hpp"
