#pragma once

#include <Eigen/Core>
#include <vector>

#include "contensou/integrate/implicit_stage.hpp"
#include "contensou/integrate/motion.hpp"

namespace contensou {

/// What a time-step takes out of the motion, puts in and leaves out, summed over its stages.
class StepAccounts {
 public:
  explicit StepAccounts(const MechanicalSystem& system);

  void clear();
  /// −weight Λ·γ of the stage last solved.
  void add_power(const ImplicitStage& stage, double weight);
  /// −Λ·½(γ_start + γ) of the stage or impact last solved, γ_start that of `u_start`: by rows, or, with a
  /// landing, all as impact.
  void add_impulses(const ImplicitStage& stage, const Eigen::VectorXd& u_start, bool landing);
  /// What works() did in a stage at (t, q) over `dt`, of which u went from `u0` to `u1`.
  void add_work(double t, double dt, const Eigen::VectorXd& q, const Eigen::VectorXd& u0,
                const Eigen::VectorXd& u1);

  const std::vector<Dissipation>& dissipated() const { return dissipated_; }
  /// To what the run did.
  void add_to(RunReport& run) const;

 private:
  void add_driven(const ImplicitStage& stage, std::size_t k, double weight);
  void add_left_out(const ImplicitStage& stage, std::size_t k, double weight);

  const MechanicalSystem& system_;
  bool drives_;  ///< system.driven()
  std::vector<Dissipation> dissipated_;
  LeftOut left_out_;
  Eigen::VectorXd work_, power_, u_mean_, gamma_start_;
};

}  // namespace contensou
