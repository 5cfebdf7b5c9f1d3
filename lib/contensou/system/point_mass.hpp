#pragma once

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

/// A point mass, or a block that does not turn, over the plane z = 0. The axes are those of the plane: if it
/// is inclined, gravity has a component along +x.
struct PointMassData {
  double m = 1;        ///< [kg] > 0
  double g = 9.81;     ///< [m/s²] >= 0
  double tilt = 0;     ///< inclination of the plane, down towards +x [rad], −π/2 to π/2
  double force_x = 0;  ///< a constant force along the plane [N]
  double force_y = 0;
};

/// q = (x, y, z), u = q̇, M = m·1, h = (f_x + mg sin α, f_y, −mg cos α); one contact, frictionless or with
/// Coulomb friction,
///     g_N = z,   γ_N = ż,   γ_T = (ẋ, ẏ),
/// and with a restitution a bouncing ball. All terms but γ are constant.
class PointMass final : public MechanicalSystem {
 public:
  /// Throws std::invalid_argument with one line for data or a contact that make no sense; a point does not
  /// spin, so that four rows do not.
  PointMass(const PointMassData& data, const SystemContact& contact);

  const PointMassData& data() const { return data_; }

  Eigen::Index coordinates() const override { return 3; }
  Eigen::Index velocities() const override { return 3; }

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  double gap(std::size_t contact, double t, ConstVector q) const override;
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  /// −h·q: of gravity and of the constant force, zero at q = 0.
  double potential_energy(ConstVector q) const override;

 private:
  PointMassData data_;
  Eigen::Vector3d force_;
  Eigen::Vector3d acceleration_;
  int rows_;
};

}  // namespace contensou
