#pragma once

#include <Eigen/Core>
#include <vector>

#include "contensou/integrate/implicit_stage.hpp"
#include "contensou/integrate/step_accounts.hpp"

namespace contensou {

/// A state with what its contacts are.
struct ContactState {
  Eigen::VectorXd q;
  Eigen::VectorXd u;
  std::vector<ContactMode> modes;
};

/// One time-step of `moreau` and of `moreau_implicit`, see moreau.hpp. Of a step that was not accepted
/// nothing is kept but guesses.
class MoreauStep {
 public:
  enum class Kind {
    second_order,  ///< SDIRK2 where contacts stay what they are, else `implicit`
    implicit,      ///< backward Euler throughout
  };
  using Outcome = ImplicitStage::Outcome;

  /// `report`, which outlives this, is counted in.
  MoreauStep(const MechanicalSystem& system, const IntegratorOptions& options, Kind kind, RunReport& report);

  /// From (t, start) over dt > 0.
  Outcome attempt(double t, const ContactState& start, double dt);
  // Of the last attempt that was solved:
  const ContactState& end() const { return end_; }
  /// Whether contacts stayed what they were.
  bool smooth() const { return smooth_; }
  const StepAccounts& accounts() const { return accounts_; }
  /// Whether a contact that an impact would have left open, or left bouncing with its ε_N, was kept closed:
  /// the step is too long to see it.
  bool suppressed() const { return suppressed_; }
  /// When the events of a step from t0 to t1 were: at the landing, else at its end.
  double time_of_events(double t0, double t1) const { return landed_ < 1 ? t0 + landed_ * (t1 - t0) : t1; }
  /// Contacts that were hit and are open at start and end.
  const std::vector<std::size_t>& bounced() const { return bounced_; }
  /// The motion at t + θdt, restore() not yet applied: q cubic, u linear; where a contact landed, both linear
  /// before and after.
  void interpolate(double theta, Eigen::VectorXd& q, Eigen::VectorXd& u) const;

 private:
  struct Landing {
    std::size_t contact;
    double when;    ///< of the step, 0 to 1
    double change;  ///< of γ_N over the whole step, without impact [m/s]
  };

  Outcome second_order(double t, const ContactState& start, double dt);
  Outcome euler(double t, const ContactState& start, double dt);
  Outcome land(double t, const ContactState& start, double dt);
  void find_landings(double t, const ContactState& start, double dt);
  void read_modes();
  double normal_velocity(std::size_t contact, double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u);
  Outcome fly(double t, const ContactState& start, double dt);
  void close_gaps(double t);

  const MechanicalSystem& system_;
  Kind kind_;
  ImplicitStage stage_;
  std::vector<std::size_t> closed_;
  std::vector<Landing> landings_;
  ContactState end_;
  StepAccounts accounts_;
  bool smooth_ = true;
  bool suppressed_ = false;
  std::vector<std::size_t> bounced_;
  std::vector<std::size_t> left_open_;  ///< by an impact
  double landed_ = 1;                   ///< when, in steps; 1: not
  ContactState before_impact_;
  Eigen::VectorXd u_after_impact_;

  ContactRows contact_;
  // Guesses: of the last stage and the one before, and the change of one into the other.
  Eigen::VectorXd acceleration_, first_acceleration_, jerk_;
  Eigen::VectorXd q1_, u1_, q_base_, u_base_, rates_;
  Eigen::VectorXd q_start_, u_start_, rates_start_, rates_end_;
  double dt_ = 0;
};

/// Ends a run whose step was not solved.
RunReport& end_run(RunReport& report, MoreauStep::Outcome outcome, double t);

}  // namespace contensou
