#pragma once

#include "contensou/system/tippe_top_model.hpp"

namespace contensou {

/// The tippe-top in Euler angles, LG03 (5.4)–(5.21): q = (x_S, y_S, z_S, θ, φ, ψ), u = q̇; M and h of (5.9),
/// W_N, W_T, W_τ of (5.16), (5.20), (5.21), gaps of (5.13), (5.14). θ is any number: it may pass through 0
/// and π, as it does in an integration that does not notice.
///
/// Singular where sinθ = 0: there M has no inverse, and what is written of M⁻¹h and M⁻¹W is infinite or
/// undefined; near it, these grow like 1/sinθ (columns of T) and lose as many digits as φ̇ and ψ̇ cancel in
/// φ̇cosθ + ψ̇.
class TippeTopEuler final : public TippeTopModel {
 public:
  /// Throws std::invalid_argument with one line for data or contacts that make no sense.
  TippeTopEuler(const TippeTopData& data, const std::array<SystemContact, 2>& contacts);

  Eigen::Index coordinates() const override { return 6; }
  Eigen::Index velocities() const override { return 6; }

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  double gap(std::size_t contact, double t, ConstVector q) const override;
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  double potential_energy(ConstVector q) const override;

  /// As TippeTopModel::start; also throws for theta = 0 and π (as a double), where M is singular.
  State start(double theta, double psi_dot, std::optional<double> z_s = {}) const override;
  double inclination(ConstVector q) const override;
  double height(ConstVector q) const override { return q[2]; }
  Eigen::Vector3d axis(ConstVector q) const override;
  Eigen::Vector3d spin(ConstVector q, ConstVector u) const override;
};

}  // namespace contensou
