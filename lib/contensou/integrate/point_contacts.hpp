#pragma once

#include <Eigen/Core>
#include <vector>

#include "contensou/integrate/coulomb_limit.hpp"
#include "contensou/integrate/motion.hpp"
#include "contensou/integrate/step_contacts.hpp"

namespace contensou {

/// Which contacts with drilling friction a stage may take for point contacts, by IntegratorOptions::fidelity:
/// those whose slip ratio at the end of the last stage (where that is not known: at the stage's guess) is by
/// a quarter larger than the least one allowed (coulomb_limit.hpp), as long as it is not below that in the
/// solution. Contacts are counted as chosen in StepContacts, by k.
class PointContacts {
 public:
  PointContacts(const MechanicalSystem& system, const IntegratorOptions& options);

  /// Whether there is anything to do at all: a fidelity is given.
  bool asked_for() const { return !limits_.empty(); }
  /// None of `chosen` contacts, and the slip of all is unknown: others were chosen, or velocities jump.
  void forget(std::size_t chosen);
  /// None, with the slip as it is known.
  void take_none();
  /// Chooses them for a stage at time t from q, guesses u and λ (of all contacts of the system).
  void find(const StepContacts& contacts, double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u,
            const std::vector<Eigen::Vector4d>& force);
  /// For StepContacts::take_for_points; and whether there are any.
  const std::vector<char>& points() const { return points_; }
  bool any() const;

  /// Looks at a stage that was solved with what was chosen, Λ = wλ; slip up to `uncertain` may be none.
  /// Whether all points may be that.
  bool hold(const StepContacts& contacts, double w, const Eigen::VectorXd& u, const Eigen::VectorXd& impulse,
            const Eigen::VectorXd& gamma, double uncertain);
  /// A bound on max(1 − ξ, η) at the γ of a point, the part of μΛ_N that its friction is wrong by: at most
  /// the fidelity; 0 where it is open.
  double left_out(std::size_t k) const { return left_out_[k]; }

 private:
  double drilling_factor(std::size_t contact, double lambda_n) const;

  const MechanicalSystem& system_;
  std::vector<CoulombLimit> limits_;   ///< of each contact of the system; empty without fidelity
  std::vector<Eigen::Vector2d> slip_;  ///< ‖γ_T‖, |γ_τ| of each; NaN: not known
  ContactRows rows_;
  std::vector<char> points_;
  std::vector<double> left_out_;
};

}  // namespace contensou
