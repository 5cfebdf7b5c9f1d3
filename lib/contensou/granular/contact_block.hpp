#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "contensou/granular/body_motion.hpp"

namespace contensou {

/// One contact of a step, of 1, 3 or 4 rows (N, T1, T2, τ), between two bodies or a body and a plane. Its
/// rows act on the bodies' velocities through
///     γ = axesᵀ(v + ω × ρ − v' − ω' × ρ') (+ R n·(ω − ω') in the last row),
/// and are kept as axes and arms: W is never written out but for the contact's own block.
template <int rows>
struct ContactBlock {
  static constexpr int directions = rows == 1 ? 1 : 3;
  using Vector = Eigen::Matrix<double, rows, 1>;

  std::uint32_t pair;                         ///< index in PairList::pairs
  std::uint32_t first, second;                ///< bodies; second: the number of bodies for a plane
  Eigen::Matrix<double, 3, directions> axes;  ///< n from the second to the first, t_1, t_2
  Eigen::Vector3d arm, other;                 ///< ρ, ρ': from the centres of mass to the contact [m]
  double radius;                              ///< R [m]; four rows
  double target;                              ///< c [m/s]: 0 <= γ_N − c ⊥ Λ_N >= 0
  double step;                                ///< r of the natural map [kg]
  double weight;                              ///< √r
  bool plain;                                 ///< W_ii is diagonal, both tangential entries the same
  Eigen::Matrix<double, rows, rows> w;        ///< W_ii [1/kg]
  Vector impulse;                             ///< Λ [N s]

  Vector velocity(const std::vector<Twist>& twists) const {
    const Twist& a = twists[first];
    const Twist& b = twists[second];
    const Eigen::Vector3d relative = a.v - b.v + a.omega.cross(arm) - b.omega.cross(other);
    Vector gamma;
    gamma.template head<directions>() = axes.transpose() * relative;
    if constexpr (rows == 4) gamma[3] = radius * axes.col(0).dot(a.omega - b.omega);
    return gamma;
  }

  /// Adds M⁻¹W `change` to the velocities.
  void apply(const Vector& change, const std::vector<Mobility>& mobility, std::vector<Twist>& twists) const {
    const Eigen::Vector3d force = axes * change.template head<directions>();
    push(mobility[first], arm, force, change, 1, twists[first]);
    // What stands still is shared: not written to.
    if (second + 1 < twists.size()) push(mobility[second], other, force, change, -1, twists[second]);
  }

 private:
  void push(const Mobility& m, const Eigen::Vector3d& lever, const Eigen::Vector3d& force,
            const Vector& change, double sign, Twist& twist) const {
    Eigen::Vector3d torque = lever.cross(force);
    if constexpr (rows == 4) torque += radius * change[3] * axes.col(0);
    twist.v += sign * m.linear * force;
    twist.omega += sign * (m.angular * torque);
  }
};

/// W_ii of a contact whose axes, arms and radius are there.
template <int rows>
Eigen::Matrix<double, rows, rows> own_block(const ContactBlock<rows>& c,
                                            const std::vector<Mobility>& mobility) {
  constexpr int directions = ContactBlock<rows>::directions;
  Eigen::Matrix<double, rows, rows> w = Eigen::Matrix<double, rows, rows>::Zero();
  const auto add = [&](const Mobility& m, const Eigen::Vector3d& lever) {
    Eigen::Matrix<double, 3, rows> turning;
    for (int k = 0; k < directions; ++k) turning.col(k) = lever.cross(c.axes.col(k));
    if constexpr (rows == 4) turning.col(3) = c.radius * c.axes.col(0);
    w.noalias() += turning.transpose() * m.angular * turning;
    w.diagonal().template head<directions>().array() += m.linear;
  };
  add(mobility[c.first], c.arm);
  add(mobility[c.second], c.other);
  return w;
}

}  // namespace contensou
