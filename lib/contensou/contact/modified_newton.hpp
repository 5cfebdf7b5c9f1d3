#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// What solve_modified_newton keeps from one problem to the next, so that it need not allocate.
struct ModifiedNewtonMemory {
  Eigen::VectorXd natural_step;
  Eigen::VectorXd safe_step;
  Eigen::VectorXd velocity;
  Eigen::VectorXd previous_impulse;
  Eigen::VectorXd previous_velocity;
  Eigen::VectorXd best;
};

/// s_i [kg] of each contact for which Λ ← Π(Λ − ω s γ) converges for every 0 < ω < 2 as long as the sizes of
/// the friction domains stand still: 1/(largest sum of |entries| in a row of W that belongs to the contact);
/// where that is zero, as natural_steps. `step` is resized to the number of contacts.
///
/// Why: with the sizes fixed (frictionless contacts, or Tresca's friction) and W symmetric, the inclusion is
/// the condition of least ½ΛᵀWΛ + bᵀΛ over a product of convex sets, and the iteration a projected gradient
/// step in the metric S⁻¹, S = diag(s_i). It descends for ω < 2/λ_max(SW), and λ_max(SW) <= ‖SW‖_∞ <= 1.
void safe_steps(const ContactProblem& problem, Eigen::VectorXd& step);

/// The "Modified Newton Method" of LG03 4.1 for (4.17), in truth Uzawa's iteration: all contacts at once,
///     Λ_N ← prox_{R+}(Λ_N − rγ_N),   Λ_F ← prox_{B(μΛ_N)}(Λ_F − rγ_F),   γ = WΛ + b,
/// which is steps 1 and 2 with Δu eliminated and with u⁻ where step 2 prints u^k. It ends by the natural
/// map's residual and not by the printed ‖ΔΛ_N‖ + ‖ΔΛ_F‖, which is r times a residual and as small as r is.
///
/// options.r given [kg]: that one r for all rows, as printed. In stick it converges for r < 2/λ_max(W);
/// above, it cycles (`stalled`) or grows (`diverged`). A row whose W is small beside λ_max, as is that of Λ_τ
/// with R², takes a number of iterations that is larger in proportion.
///
/// Not given: r_i = ω s_i with safe_steps and the same ω for all contacts, from the curvature met in the last
/// step (Barzilai and Borwein): ω = ΔΛᵀS⁻¹ΔΛ/ΔΛᵀΔγ and ω = ΔΛᵀΔγ/ΔγᵀSΔγ in turn, both >= 1 for symmetric W.
/// It has no guarantee to descend, so the residual is watched. Where 200 iterations bring no better one, ω is
/// held below a tenth of the bound before, in the end below one; where it exceeds the best a thousandfold,
/// the iteration also returns to the best impulses. Each better residual raises the bound by a tenth. With
/// friction that follows Λ_N the problem is no minimisation, and convergence is then not proven for any r.
///
/// At most 20000 iterations unless limited otherwise; `stalled` after 2000 without a residual lower by 1e-6
/// of itself, or where rounding leaves nothing to change. Of all impulses met, the best are returned.
///
/// The method SolverMethod::modified_newton. Preconditions: those of ContactSolver::solve's methods, see
/// there.
SolverReport solve_modified_newton(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                   const SolverOptions& options, ModifiedNewtonMemory& memory);

}  // namespace contensou
