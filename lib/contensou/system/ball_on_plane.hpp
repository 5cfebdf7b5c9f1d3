#pragma once

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

/// A homogeneous ball over the plane z = 0. The axes are those of the plane: if it is inclined, gravity has a
/// component along +x.
struct BallOnPlaneData {
  double m = 1;     ///< [kg] > 0
  double r = 1;     ///< radius of the ball [m] > 0
  double g = 9.81;  ///< [m/s²] >= 0
  double tilt = 0;  ///< inclination of the plane, down towards +x [rad], −π/2 to π/2
};

/// q = (x, y, z) of the centre, u = (v, ω) in the plane's axes; which side of the ball is up makes no
/// difference and is not carried. M = diag(m, m, m, I, I, I) with I = 2/5 mr², h = mg(sin α, 0, −cos α, 0, 0,
/// 0). One contact, frictionless, Coulomb or Coulomb–Contensou,
///     g_N = z − r,   γ_N = v_z,   γ_T = (v_x − rω_y, v_y + rω_x),   γ_τ = Rω_z,   R the radius of the
///     contact.
/// All terms but γ are constant.
class BallOnPlane final : public MechanicalSystem {
 public:
  /// Throws std::invalid_argument with one line for data or a contact that make no sense.
  BallOnPlane(const BallOnPlaneData& data, const SystemContact& contact);

  const BallOnPlaneData& data() const { return data_; }
  double inertia() const { return inertia_; }  ///< 2/5 mr² [kg m²]

  Eigen::Index coordinates() const override { return 3; }
  Eigen::Index velocities() const override { return 6; }
  void coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const override;
  double length_scale() const override { return data_.r; }
  void coordinate_scales(VectorRef scales) const override;

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  double gap(std::size_t contact, double t, ConstVector q) const override;
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  double potential_energy(ConstVector q) const override;  ///< zero for the centre at q = 0

 private:
  BallOnPlaneData data_;
  double inertia_;
  Eigen::Vector3d gravity_;  ///< [m/s²]
  double radius_;
  int rows_;
};

}  // namespace contensou
