#pragma once

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

/// Principal moments of inertia of a rigid body, each at most the sum of the others.
struct FreeBodyData {
  double i1 = 1;  ///< [kg m²] > 0
  double i2 = 2;  ///< [kg m²] > 0
  double i3 = 3;  ///< [kg m²] > 0
};

/// A rigid body that turns about its centre of mass, free of torques and of contacts:
///     q = (a, b, c, d), the unit quaternion a + bi + cj + dk that takes the body's axes to the space's,
///     u = ω in the body's principal axes,   q̇ = ½ q (0, ω),   M = diag(I_1, I_2, I_3),   h = −ω × Mω.
/// The quaternion is taken to be of unit length; where it is not (within a step), all is a smooth
/// continuation.
class FreeBody final : public MechanicalSystem {
 public:
  /// Throws std::invalid_argument with one line for data that make no sense.
  explicit FreeBody(const FreeBodyData& data);

  const FreeBodyData& data() const { return data_; }
  /// The body's axes in space, by columns.
  Eigen::Matrix3d attitude(ConstVector q) const;
  /// Conserved: the angular momentum in the space's axes [kg m²/s].
  Eigen::Vector3d angular_momentum(ConstVector q, ConstVector u) const;

  Eigen::Index coordinates() const override { return 4; }
  Eigen::Index velocities() const override { return 3; }
  void coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const override;
  /// q to unit length; left alone where |q|² is 1 within 4 roundings, so that restoring twice is restoring
  /// once.
  void restore(VectorRef q) const override;

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  /// There is no contact: throws std::out_of_range.
  double gap(std::size_t contact, double t, ConstVector q) const override;
  /// There is no contact: throws std::out_of_range.
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  double potential_energy(ConstVector q) const override;  ///< zero

 private:
  FreeBodyData data_;
  Eigen::Vector3d inertia_;
};

}  // namespace contensou
