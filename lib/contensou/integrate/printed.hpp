#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/integrate/step_contacts.hpp"

namespace contensou {

/// What Tables 1 and 2 of LG03 share, to the letter: half a step for the positions, the contacts that are
/// closed there, and the iteration for their impulses. What the letter is where it leaves something open:
///
/// - `r` of (4.16): one number for all rows, options.r. Where none is given, in each problem anew
///   r = 1/‖W‖_∞, W = W_MᵀM_M⁻¹W_M over all closed rows: r <= 1/λ_max(W), half of what is needed to converge
///   while the sizes of the friction domains stand still (modified_newton.hpp). The price is that rows whose
///   W is small, above all that of Λ_τ with R², need up to λ_max/λ_min iterations for each e-fold where they
///   stick.
/// - Λ_F: (T1, T2, τ) as far as the contact has them, Λ_τ being (impulsive torque)/R.
/// - The iteration ends with ‖ΔΛ_N‖ + ‖ΔΛ_F‖ < tol, as printed: options.solver_tolerance [N s]. That is r
///   times a residual and so says the less, the smaller r is. It is bounded here by `most_iterations`; where
///   it does not end before, the step goes on with what it has. The run's message then tells how often and
///   when first.
/// - As printed, u_E goes with the impulses of the last iteration but one.
/// - q̇ = F(q)u where the paper has q̇ = u, with F at the start of each piece: q_M = q_A + ½Δt F(q_A)u_A,
///   q_E = q_M + ½Δt F(q_M)u_E. The letter knows no restore(): with LG03's own coordinates (Euler angles) it
///   changes nothing; with others (an axis) q is restored after each whole step.
/// - No restitution: LG03 has ε_N = 0. Contacts with another one are refused.
/// - N steps of Δt = (t_end − t_0)/(N − 1) end one step late, at t_end + Δt. Here N − 1 steps are made, which
///   end at t_end. Whoever wants the letter's last step asks for t_end + Δt.
class PrintedContacts {
 public:
  static constexpr int most_iterations = 20000;

  /// `report`, which outlives this, is counted in. Throws std::invalid_argument for a contact with
  /// restitution.
  PrintedContacts(const MechanicalSystem& system, const IntegratorOptions& options, RunReport& report);

  /// From (t_A, q_A, u_A) over Δt: q_E, u_E; the body of Table 1's loop, and all but a_m of Table 2's
  /// ComputeStage.
  void step(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u, double dt);
  const Eigen::VectorXd& q_mid() const { return q_mid_; }
  const Eigen::VectorXd& q() const { return q_end_; }
  const Eigen::VectorXd& u() const { return u_end_; }

  /// Between begin_whole_step() and end_whole_step(): takes `weight` times the impulses of the last step()
  /// into the whole time-step.
  void add(double weight);
  void begin_whole_step();
  /// Of all that was added: dissipation −Λ·½(γ_start + γ_end), exact for the change of kinetic energy where M
  /// and W are constant, as sliding and drilling, or, where a contact closed, all of it as impact, since an
  /// impact is felt in all contacts. Modes: closed are contacts with Λ_N > 0; sticking those that moved, in
  /// each of their problems, by less than what tol may hide, tol/r.
  void end_whole_step(const Eigen::VectorXd& u_start, const Eigen::VectorXd& u_end,
                      const std::vector<ContactMode>& before);
  const std::vector<ContactMode>& modes() const { return modes_; }

  /// What to say at the end of the run; empty where all iterations converged.
  std::string complaint() const;

 private:
  void classify(double t);
  void iterate(double t, const Eigen::VectorXd& u, double dt);

  const MechanicalSystem& system_;
  RunReport& report_;
  double tolerance_;
  std::optional<double> given_r_;
  double r_ = 0;

  StepContacts contacts_;
  std::vector<std::size_t> closed_;
  std::vector<Eigen::Vector4d> kept_;  ///< Λ of all contacts, for the next step to start from
  std::vector<ContactMode> modes_;
  /// Of each contact: Σ weight WΛ by (N, T, τ), f × 3, and Σ weight Λw̃, 3.
  std::vector<Eigen::Matrix<double, Eigen::Dynamic, 3>> momentum_;
  std::vector<Eigen::Vector3d> driven_;
  double t_mid_ = 0, dt_ = 0;
  Eigen::VectorXd u_mean_, power_;  ///< of the last step()
  Eigen::VectorXd q_mid_, q_end_, u_end_, rates_, free_;
  Eigen::VectorXd impulse_, gamma_;
  std::int64_t failures_ = 0;
  double first_failure_ = 0;
};

}  // namespace contensou
