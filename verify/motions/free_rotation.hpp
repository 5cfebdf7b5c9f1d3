#pragma once

#include <Eigen/Core>
#include <array>

namespace known_motions {

/// Euler's top from the identity attitude: ω(t) in the body's axes and the attitude R(t), columns the body's
/// axes in space. Landau & Lifshitz, Mechanics, §37.
///
/// Three different moments of inertia, none of the motions that Jacobi's functions degenerate for (steady
/// rotation, separatrix). With c the axis, of largest or smallest moment, about which the angular momentum
/// circles in the body, b the middle one:
///     ω_a = A cn(τ, k),   ω_b = B sn(τ, k),   ω_c = C dn(τ, k),
/// and about the fixed L the line L × e_c turns with L(2T − I_cω_c²)/(L² − I_c²ω_c²), integrated by Gauss and
/// Kronrod's rule.
class FreeRotation {
 public:
  FreeRotation(const Eigen::Vector3d& inertia, const Eigen::Vector3d& omega);

  Eigen::Vector3d omega(double t) const;
  Eigen::Matrix3d attitude(double t) const;

 private:
  Eigen::Matrix3d frame(const Eigen::Vector3d& angular_momentum) const;

  Eigen::Vector3d inertia_;
  Eigen::Vector3d start_;
  double twice_energy_;
  std::array<int, 3> axis_;    ///< a, b, c
  Eigen::Vector3d amplitude_;  ///< A, B, C
  double rate_;                ///< dτ/dt
  double phase_;               ///< τ at t = 0
  double modulus_;             ///< k
};

/// The same with I_1 = I_2 = `across`: R = rot(L, ‖L‖t/I_1) rot(e_3, (1 − I_3/I_1)ω_3 t).
class SymmetricRotation {
 public:
  SymmetricRotation(double across, double along, const Eigen::Vector3d& omega);

  Eigen::Vector3d omega(double t) const;
  Eigen::Matrix3d attitude(double t) const;

 private:
  Eigen::Vector3d start_;
  Eigen::Vector3d precession_;  ///< L/I_1
  double spin_;                 ///< of the body about e_3 in the precessing frame
};

}  // namespace known_motions
