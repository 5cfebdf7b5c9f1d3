#pragma once

#include <Eigen/Core>

#include "contensou/ball/friction_disk.hpp"
#include "contensou/ball/friction_domain.hpp"

namespace contensou {

/// Sliding and drilling friction that know nothing of each other (DecoupledLaw, law/approximations.hpp): the
/// forces (λ_T1, λ_T2, λ_τ) [N] with ‖λ_T‖ <= μλ_N, |λ_τ| <= η_max μλ_N, disk × interval. Its support
/// function is size (‖γ_T‖ + η_max |γ_τ|). A FrictionDomain in closed form, to a few ulp: no iteration, no
/// residual; errors as stated there. The same set as FrictionBall<RectanglePlate>, for contacts.
class FrictionCylinder {
 public:
  static constexpr int dimension = 3;

  /// Half-height in (0, ∞), a law's extent().eta: 2/3 for uniform pressure, 3π/16 for Hertz's. Throws
  /// std::invalid_argument otherwise.
  explicit FrictionCylinder(double eta_max);
  double eta_max() const { return eta_max_; }
  /// Largest |λ_τ|, kept finite; `size` >= 0, not checked.
  double half_height(double size) const;

  double support(double size, const Eigen::Vector3d& gamma) const;
  double gauge(const Eigen::Vector3d& force) const;
  bool contains(const Eigen::Vector3d& force, double size) const;
  Projection<3> project(const Eigen::Vector3d& force, double size) const;
  ProjectionDerivative<3> derivative(const Projection<3>& q, const Eigen::Vector3d& force, double size) const;

 private:
  double eta_max_;
  FrictionDisk disk_;
};

}  // namespace contensou
