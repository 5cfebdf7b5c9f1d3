#pragma once

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

/// A body that lies flat on the plane z = 0 and stays upright: a disc, a coin, a curling stone.
struct SlidingDiscData {
  double m = 1;     ///< [kg] > 0
  double i = 0.5;   ///< about the vertical through the centre [kg m²] > 0; of a homogeneous disc ½mR²
  double g = 9.81;  ///< [m/s²] >= 0
};

/// q = (x, y, z, φ), u = q̇, M = diag(m, m, m, I), h = (0, 0, −mg, 0). The disc has three degrees of freedom
/// while it lies; z is there for the load of the contact to come out of the contact's own law, λ_N = mg:
///     g_N = z,   γ_N = ż,   γ_T = (ẋ, ẏ),   γ_τ = Rφ̇,   R the radius of the contact.
/// The pressure is that of the friction law whatever the motion: the torque of the friction force about the
/// centre of mass, which presses a disc of finite height down in front, is left out. All terms but γ are
/// constant.
class SlidingDisc final : public MechanicalSystem {
 public:
  /// Throws std::invalid_argument with one line for data or a contact that make no sense. The contact may
  /// have any number of rows.
  SlidingDisc(const SlidingDiscData& data, const SystemContact& contact);

  const SlidingDiscData& data() const { return data_; }

  Eigen::Index coordinates() const override { return 4; }
  Eigen::Index velocities() const override { return 4; }
  /// The radius of gyration √(I/m).
  double length_scale() const override;
  void coordinate_scales(VectorRef scales) const override;

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  double gap(std::size_t contact, double t, ConstVector q) const override;
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  double potential_energy(ConstVector q) const override;

 private:
  SlidingDiscData data_;
  double radius_;
  int rows_;
};

}  // namespace contensou
