#pragma once

#include <Eigen/Core>

#include "contensou/ball/friction_domain.hpp"

namespace contensou {

/// Coulomb's friction disk D_T, LG03 (2.15): the forces (λ_T1, λ_T2) [N] of length at most μλ_N. What a point
/// contact has: no torque, no contact radius. A FrictionDomain: errors as stated there.
class FrictionDisk {
 public:
  static constexpr int dimension = 2;

  double support(double size, const Eigen::Vector2d& gamma) const;
  double gauge(const Eigen::Vector2d& force) const;
  bool contains(const Eigen::Vector2d& force, double size) const;
  Projection<2> project(const Eigen::Vector2d& force, double size) const;
  ProjectionDerivative<2> derivative(const Projection<2>& q, const Eigen::Vector2d& force, double size) const;
};

}  // namespace contensou
