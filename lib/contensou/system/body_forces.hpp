#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contensou/system/body_layout.hpp"

namespace contensou {

/// What acts on rigid bodies beside contacts: gravity, gyroscopic torques, air drag, loads; with
/// M = diag(m, m, m, and I_1, I_2, I_3 of a free body or I_3 of an upright one).
///     free:     I ω̇ = −ω × Iω − c_ω ω + Aᵀτ, in the body's axes, A those axes in space
///     upright:  I_3 φ̈ = −c_ω φ̇ + e_3·τ
/// What is absent is not there: lists are made at construction of what there is, and a free body with three
/// equal moments has no gyroscopic torque. Gravity and constant forces cost one copy of f numbers.
class BodyForces {
 public:
  /// `layout` and its data outlive this.
  explicit BodyForces(const BodyLayout& layout);

  const Eigen::VectorXd& mass() const { return mass_; }                  ///< the diagonal of M, f
  const Eigen::VectorXd& inverse_mass() const { return inverse_mass_; }  ///< of M⁻¹
  /// M⁻¹h(t, q, u), f.
  void acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const;

  /// "air drag" if a body has drag, then "load NAME" of each load; empty without any.
  const std::vector<std::string>& works() const { return works_; }
  /// The power into the motion by each of these [W].
  void powers(double t, ConstVector q, ConstVector u, VectorRef power) const;

 private:
  /// ω̇ = (k_1 ω_2ω_3, k_2 ω_3ω_1, k_3 ω_1ω_2), k_1 = (I_2 − I_3)/I_1 and so on.
  struct Gyroscopic {
    Eigen::Index first;
    Eigen::Vector3d k;
  };
  /// Of one velocity u_i.
  struct Damped {
    Eigen::Index index;
    double rate;      ///< c/m [1/s]
    double constant;  ///< c
  };
  /// The part of a load that is not constant: along three velocities, the axis of an upright body, or about
  /// those of a free one.
  struct Push {
    const LoadData* load;
    Eigen::Index first;
    Eigen::Vector3d acceleration;
  };
  struct Spin {
    const LoadData* load;
    Eigen::Index index;
    double acceleration;
  };
  struct Twist {
    const LoadData* load;
    Eigen::Index first;  ///< of the angular velocity
  };

  void add_body(const BodyData& body, Eigen::Index first);
  void add_load(const LoadData& load);

  const BodyLayout& layout_;
  Eigen::VectorXd mass_, inverse_mass_;
  Eigen::VectorXd constant_;  ///< the part of the acceleration that is
  std::vector<Gyroscopic> gyroscopic_;
  std::vector<Damped> damped_;
  std::vector<Push> pushes_;
  std::vector<Spin> spins_;
  std::vector<Twist> twists_;
  std::vector<std::string> works_;
};

}  // namespace contensou
