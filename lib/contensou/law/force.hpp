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

/// The friction at γ_F = 0: not a number but every force of the friction ball B_F(λ_N), LG03 (2.19), with
/// semi-axes radius_t [N] in the tangent plane and half_height_tau [N] along λ_τ. Both zero where μλ_N = 0.
/// Which forces belong to it, which is nearest, is not for two semi-axes to say: FrictionBall
/// (ball/friction_ball.hpp).
struct FrictionSet {
  double radius_t;
  double half_height_tau;
};

using FrictionResponse = std::variant<FrictionForce, FrictionSet>;

/// λ_F(γ_F): −λ_F ∈ ∂Φ(γ_F), LG03 (2.11), (2.20). A force where γ_F ≠ 0, the
/// whole set where γ_F = 0; a law that is smooth at rest (it says so by
/// `static constexpr bool smooth_at_rest = true`) gives the force zero there.
///
/// No overflow or underflow on the way, whatever the size of γ_F, μ and λ_N: a few ulp
/// beside the error of the law wherever ξ, η, the components of γ_T/‖γ_T‖ and the
/// result are normal numbers; a result beyond the range of doubles is infinite.
/// γ_F → 2^k γ_F leaves the force of a law without a scale of its own unchanged to
/// the bit, λ_N → 2^k λ_N multiplies it by 2^k.
///
/// Throws std::invalid_argument for a negative or non-finite
/// μ or λ_N, std::domain_error for a NaN or infinite γ_F.
template <FrictionLaw L>
FrictionResponse friction_force(const L& law, const Load& load, const SlipVelocity& gamma);

/// Φ(γ_F) = −λ_F·γ_F [W], LG03 (2.1); zero at γ_F = 0. A law with a potential of its own is asked for it.
/// Same accuracy and errors as friction_force.
template <FrictionLaw L>
double potential(const L& law, const Load& load, const SlipVelocity& gamma);

/// ∂²Φ/∂γ_F² = −∂λ_F/∂γ_F [N s/m], symmetric, positive semi-definite, with γ_F in its null space for a law
/// that depends on u only and has a potential. With n = γ_T/‖γ_T‖, v = ‖γ_T‖, s = |γ_τ|, in units of μλ_N:
///   tangent plane Φ_vv n nᵀ + (ξ/v)(I − n nᵀ),  mixed Φ_vs n sgn γ_τ,  spin Φ_ss.
/// At γ_T = 0 it is the limit (f''(0)/s, 0, 0), at γ_τ = 0 the limit (transverse 1/v, spin tail/v); where a
/// law has no such limit (disk × interval) it throws std::domain_error, as at γ_F = 0, where Φ has no
/// derivative. Otherwise errors as friction_force. Same accuracy as the law's curvature; an entry beyond the
/// range of doubles is infinite, none is NaN.
template <FrictionLaw L>
Eigen::Matrix3d hessian(const L& law, const Load& load, const SlipVelocity& gamma);

}  // namespace contensou

#include "contensou/law/force_impl.hpp"
