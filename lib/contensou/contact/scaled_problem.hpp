#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

/// A contact problem without units: with x_i = Λ_i/(r_i V) and velocities in units of V = max|b|,
///     g = γ/V = w x + b,   w_ij = W_ij r_j,
/// it is h(x) = x − Π(x − S g) = 0, LG03 (4.17), for any steps S > 0, because Π_i(c x) = c Π_i(x) for c > 0.
/// r_i is the inverse of the largest diagonal entry of W_ii in the rows N, T1, T2, so that x does not depend
/// on the size of the contact radius. S is diagonal, with one step for N and one for all friction rows of a
/// contact.
class ScaledProblem {
 public:
  /// b must not be zero. `problem` must live as long as this is used. The steps are those of reset_steps.
  void set(const ContactProblem& problem);

  Eigen::Index rows() const { return b.size(); }
  /// g = w x + b.
  void velocity(const Eigen::VectorXd& x, Eigen::VectorXd& g) const;
  /// natural_map_residual of x with velocity g, as far as `rounding` of x leaves it `believable`
  /// (blocks.hpp): that of the sums w x, too, where natural_map_residual counts that of each Λ_i alone.
  double residual(const Eigen::VectorXd& x, const Eigen::VectorXd& g) const;
  /// What rounding x to doubles makes of the residual, as an order of magnitude.
  double rounding(const Eigen::VectorXd& x) const;
  /// Whether a residual of x is no larger than its rounding explains: SolverStatus::at_rounding.
  bool at_rounding(const Eigen::VectorXd& x, double residual) const;

  /// h of x with velocity g.
  void natural_map(const Eigen::VectorXd& x, const Eigen::VectorXd& g, Eigen::VectorXd& h) const;
  /// h and its Jacobian I − D (I − S w) with D from ∂Π; a further column, where `jacobian` has one, is ∂h/∂z
  /// for velocities z cover added to g.
  void natural_map(const Eigen::VectorXd& x, const Eigen::VectorXd& g, Eigen::VectorXd& h,
                   Eigen::MatrixXd& jacobian) const;

  /// Steps with which S w has ones on the diagonal in N and in the larger one of T1, T2.
  void reset_steps() { step_ = reset_step_; }
  /// Longer friction steps, up to ‖x_F‖/‖g_F‖ but not beyond `most` times those of reset_steps, in contacts
  /// that slip. A contact that slips slowly has x − S g in a layer as thin as S g outside the friction
  /// domain; beyond it the derivative is that of another state, and Newton's method sees no farther.
  void adapt_steps(const Eigen::VectorXd& x, const Eigen::VectorXd& g, double most);

  Eigen::MatrixXd w;
  Eigen::VectorXd b;
  Eigen::VectorXd unit;   ///< r_i V in each row [N s]: Λ = unit x
  Eigen::VectorXd cover;  ///< > 0 in normal rows, 0 in the others: 1, unless changed

 private:
  const ContactProblem* problem_ = nullptr;
  Eigen::VectorXd natural_;  ///< r of natural_map_residual, in units of r_i, for each contact
  Eigen::VectorXd step_;     ///< diagonal of S
  Eigen::VectorXd reset_step_;
};

}  // namespace contensou
