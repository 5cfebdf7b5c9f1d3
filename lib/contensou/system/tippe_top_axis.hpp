#pragma once

#include "contensou/system/tippe_top_model.hpp"

namespace contensou {

/// The tippe-top of LG03 Section 5 without singular attitudes, and without trigonometry:
///     q = (x_S, y_S, z_S, e),   e = e_3^4 the axis of symmetry in the floor's axes, |e| = 1;
///     u = (v_S, ω) in the floor's axes;   q̇ = (v_S, ω × e).
/// ω includes the spin about the axis; the angle of that spin is cyclic and not carried. Six coordinates on a
/// five-dimensional manifold, six velocities.
///
/// M = diag(m, m, m, I_1 + (I_3 − I_1)eeᵀ) and its inverse take e as of unit length; where it is not (within
/// a step), all is a smooth continuation. With s_i = a_i e − r_i e_3^1 from S to the contact point,
///     γ_N = [v_S + ω × s]_3,   γ_T = [v_S + ω × s]_{1,2},   γ_τ = Rω_3:
/// (5.15), (5.19), (5.21) in other coordinates, the same numbers.
class TippeTopAxis final : public TippeTopModel {
 public:
  /// Throws std::invalid_argument with one line for data or contacts that make no sense.
  TippeTopAxis(const TippeTopData& data, const std::array<SystemContact, 2>& contacts);

  Eigen::Index coordinates() const override { return 6; }
  Eigen::Index velocities() const override { return 6; }
  void coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const override;
  /// e to unit length; left alone where |e|² is 1 within 4 roundings, so that restoring twice is restoring
  /// once and a fresh start() keeps its gap.
  void restore(VectorRef q) const override;

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  double gap(std::size_t contact, double t, ConstVector q) const override;
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  double potential_energy(ConstVector q) const override;

  State start(double theta, double psi_dot, std::optional<double> z_s = {}) const override;
  double inclination(ConstVector q) const override;
  double height(ConstVector q) const override { return q[2]; }
  Eigen::Vector3d axis(ConstVector q) const override { return q.tail<3>(); }
  Eigen::Vector3d spin(ConstVector q, ConstVector u) const override;

 private:
  // Reciprocals, so that no evaluation divides.
  double inverse_m_;
  double inverse_i1_;
  double axial_;  ///< 1/I_3 − 1/I_1
};

}  // namespace contensou
