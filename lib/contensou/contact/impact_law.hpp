#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

/// One time-step or impact, LG03 (4.5)–(4.9), before its impulses are known. f coordinates, n rows of
/// contacts in the order of ContactProblem.
struct ImpactStep {
  Eigen::MatrixXd inverse_mass;   ///< M⁻¹ [1/kg, 1/(kg m²)], f × f, symmetric, positive semi-definite
  Eigen::MatrixXd directions;     ///< W_all = (w_N, w_F), f × n
  Eigen::VectorXd velocity;       ///< u⁻, f
  Eigen::VectorXd smooth_change;  ///< M⁻¹hΔt, f; zero for an impact alone
  Eigen::VectorXd drive;          ///< w̃ [m/s], n: the velocities of the contacts at u = 0
  Eigen::VectorXd restitution;    ///< ε_N of each contact, 0 to 1
};

/// Fills in W and b of `problem`, whose groups say what contacts there are:
///     W = W_allᵀ M⁻¹ W_all,    b = W_allᵀ(u⁻ + M⁻¹hΔt) + w̃,    and in the normal rows + ε_N γ_N⁻,
/// so that 0 <= γ_N⁺ + ε_N γ_N⁻ ⊥ Λ_N >= 0: Newton's law γ_N⁺ = −ε_N γ_N⁻ for contacts that take part in the
/// impact (LG03 has ε_N = 0), while others may leave faster. γ_N⁻ = w_Nᵀu⁻ + w̃_N, LG03 (4.5). Friction has
/// no restitution.
///
/// Energy: an impact alone with w̃ = 0 changes the kinetic energy by ½Λ·(γ⁺ + γ⁻). That is <= 0 for ε_N = 0,
/// and without friction for one ε_N in all contacts. With friction and ε_N > 0 it may be > 0: certain is
/// Λ_F·γ_F⁺ <= 0, not Λ_F·γ_F⁻ <= 0. This is a known limit of Newton's law (T.R. Kane, D.A. Levinson,
/// Dynamics: Theory and Applications, McGraw-Hill 1985), not of the solver; verify/consistency shows how
/// often.
///
/// `response` is M⁻¹ W_all. W is symmetric to the bit. Allocates nothing where the sizes are as before.
/// Throws std::invalid_argument as require_valid_groups does, and for sizes that do not fit, an entry that is
/// not finite, or ε_N outside [0, 1].
void assemble_impact(const ImpactStep& step, Eigen::MatrixXd& response, ContactProblem& problem);

/// u⁺ = u⁻ + M⁻¹hΔt + M⁻¹W_all Λ, LG03 (4.7).
Eigen::VectorXd velocity_after(const ImpactStep& step, const Eigen::MatrixXd& response,
                               const Eigen::VectorXd& impulse);

}  // namespace contensou
