#pragma once

#include <Eigen/Core>
#include <variant>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// What a contact brings to the law: μ >= 0 [-], λ_N >= 0 [N]. (The radius R is in γ_τ = ωR and τ_N = R λ_τ.)
struct Load {
  double mu;
  double lambda_n;
};

/// γ_F = (γ_T1, γ_T2, γ_τ) [m/s] with γ_τ = ωR, LG03 (2.17), (2.21).
using SlipVelocity = Eigen::Vector3d;
/// λ_F = (λ_T1, λ_T2, λ_τ) [N] with λ_τ = τ_N/R, LG03 (2.17), (2.21).
using FrictionForce = Eigen::Vector3d;

/// The friction at γ_F = 0: not a number but every force of the friction ball B_F(λ_N), LG03 (2.19), with semi-axes
/// radius_t [N] in the tangent plane and half_height_tau [N] along λ_τ. Both zero where μλ_N = 0.
struct FrictionSet {
  double radius_t;
  double half_height_tau;
};

using FrictionResponse = std::variant<FrictionForce, FrictionSet>;

/// λ_F(γ_F): −λ_F ∈ ∂Φ(γ_F), LG03 (2.11), (2.20). A force where γ_F ≠ 0, the whole set where γ_F = 0.
/// No overflow or underflow on the way: the result is accurate wherever it is a normal number.
/// Throws std::invalid_argument for a negative or non-finite μ or λ_N, std::domain_error for a NaN or infinite γ_F.
template <FrictionLaw L>
FrictionResponse friction_force(const L& law, const Load& load, const SlipVelocity& gamma);

/// Φ(γ_F) = −λ_F·γ_F [W], LG03 (2.1); zero at γ_F = 0. Same errors as friction_force.
template <FrictionLaw L>
double potential(const L& law, const Load& load, const SlipVelocity& gamma);

/// ∂²Φ/∂γ_F² = −∂λ_F/∂γ_F [N s/m], symmetric, positive semi-definite, with γ_F in its null space for a law that depends
/// on u only. Throws std::domain_error at γ_F = 0, where Φ has no derivative; otherwise as friction_force.
template <FrictionLaw L>
Eigen::Matrix3d hessian(const L& law, const Load& load, const SlipVelocity& gamma);

}  // namespace contensou
