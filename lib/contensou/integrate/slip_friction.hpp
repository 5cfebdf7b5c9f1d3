#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

/// The friction of one contact as a motion meets it, per unit of μλ_N, in the order (T1, T2, τ) with zeros
/// where the contact has fewer rows. The kind of friction is looked up when this is made, not at each use.
/// The friction given outlives it.
class SlipFriction {
 public:
  /// Throws std::invalid_argument for a FrictionCylinder: where only one of γ_T, γ_τ is zero, its friction is
  /// not given by γ_F.
  explicit SlipFriction(const AnyFriction& friction);

  /// Friction components: 0, 2 or 3.
  int dimension() const { return dimension_; }
  /// x̂(γ_F): the border point with outward normal γ_F ≠ 0; λ_F = −μλ_N x̂. Not finite for γ_F = 0.
  Eigen::Vector3d border(const Eigen::Vector3d& gamma) const { return border_(*friction_, gamma); }
  /// ∂x̂/∂γ_F for γ_F ≠ 0 and finite, else std::domain_error.
  Eigen::Matrix3d derivative(const Eigen::Vector3d& gamma) const { return derivative_(*friction_, gamma); }
  /// The size μλ_N of the domain that just reaches a force; and a unit outward normal at the border point on
  /// the ray through a force that is not zero.
  double gauge(const Eigen::Vector3d& force) const { return gauge_(*friction_, force); }
  Eigen::Vector3d normal(const Eigen::Vector3d& force) const { return normal_(*friction_, force); }

 private:
  const AnyFriction* friction_;
  int dimension_;
  Eigen::Vector3d (*border_)(const AnyFriction&, const Eigen::Vector3d&);
  Eigen::Matrix3d (*derivative_)(const AnyFriction&, const Eigen::Vector3d&);
  double (*gauge_)(const AnyFriction&, const Eigen::Vector3d&);
  Eigen::Vector3d (*normal_)(const AnyFriction&, const Eigen::Vector3d&);
};

}  // namespace contensou
