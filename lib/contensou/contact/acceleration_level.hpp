#pragma once

#include <Eigen/Core>
#include <vector>

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

/// The inclusion on acceleration level, LG03 (4.1), (4.2), for closed contacts with γ_N = 0: for forces λ,
///     γ̇ = Wλ + b,    0 <= γ̇_N ⊥ λ_N >= 0,
///     sliding (γ_F ≠ 0):   λ_F = −μλ_N x̂(γ_F), x̂ the border point with normal γ_F: given by the law;
///     sticking (γ_F = 0):  −γ̇_F ∈ N_B(μλ_N)(λ_F).
///
/// A sliding contact keeps one row, λ_N, whose column of W becomes that of w_N − μ W_F x̂: the reduced W is
/// not symmetric. Then there may be several solutions or none, and a sliding contact whose own W_NN is not
/// positive (Painlevé) has none or two; solvers say so by their status. Whoever integrates must then look for
/// an impact.
class AccelerationLevel {
 public:
  /// `full`: groups, W = W_allᵀM⁻¹W_all [1/kg] and b = W_allᵀM⁻¹h + Ẇ_allᵀu + ẇ [m/s²] with all rows of all
  /// closed contacts. `velocity`: γ [m/s], of which only the friction rows count: a contact sticks if they
  /// are exactly zero. Throws std::invalid_argument as require_valid does, for a velocity of the wrong
  /// size or not finite, and for a FrictionCylinder, of which one part may stick while the other slides.
  AccelerationLevel(const ContactProblem& full, const Eigen::VectorXd& velocity);

  /// What is left to be solved, with accelerations for velocities and forces for impulses: sticking contacts
  /// of each group first, then its sliding ones, frictionless. W is not symmetric.
  const ContactProblem& problem() const { return problem_; }

  /// All forces, from those of problem(), in the order of `full`.
  Eigen::VectorXd forces(const Eigen::VectorXd& reduced) const { return expansion_ * reduced; }
  /// The forces of problem() from all: for a warm start.
  Eigen::VectorXd reduced(const Eigen::VectorXd& forces) const { return forces(rows_); }

  /// Whether a sliding contact has W_NN <= 0: Painlevé's paradox.
  bool paradox() const { return paradox_; }

 private:
  ContactProblem problem_;
  Eigen::MatrixXd expansion_;       ///< λ = expansion λ_reduced
  std::vector<Eigen::Index> rows_;  ///< of `full`, which are left
  bool paradox_ = false;
};

}  // namespace contensou
