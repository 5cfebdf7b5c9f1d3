#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contensou/contact/contact_solver.hpp"
#include "contensou/integrate/motion.hpp"
#include "contensou/integrate/point_contacts.hpp"
#include "contensou/integrate/step_contacts.hpp"

namespace contensou {

/// One stage of an implicit time-stepping scheme with contacts on velocity level: at time t, find
/// q, u, Λ with
///     q = q_base + w F(q)u,      u = u_base + w M(q)⁻¹h(t, q, u) + M(q)⁻¹W(q)Λ,
///     0 <= γ_N − shift ⊥ Λ_N >= 0,      −γ_F ∈ N_B(μΛ_N)(Λ_F),      γ = W(q)ᵀu + w̃(q),
/// for the contacts chosen; Λ = wλ. A stage of backward Euler or of a diagonally implicit Runge–Kutta
/// method.
///
/// By fixed points: M, W and h at the last (q, u), the inclusion solved exactly, again. Contracts where
/// w ‖∂(F u, M⁻¹h)/∂(q, u)‖ < 1; friction, however stiff, is in the inclusion and no matter. Ends where
/// another round would change q and u by no more than rounding or the contact solver's tolerance.
///
/// A contact radius that follows the load (SystemContact::load_radius) is that of λ_N = Λ_N/w of the last
/// round, and zero in the first round of a contact that has just closed, which is to find its λ_N: another
/// fixed point, which contracts where the load hardly depends on friction (R goes like its third root).
///
/// With IntegratorOptions::fidelity contacts with hardly any drilling friction are taken for point contacts
/// (point_contacts.hpp). Where that does not hold in the (q, u) found, the stage is solved again with all
/// rows. Impacts always have all rows.
class ImplicitStage {
 public:
  struct Base {
    double t;  ///< of the stage
    double w;  ///< > 0 [s]
    const Eigen::VectorXd& q;
    const Eigen::VectorXd& u;
  };
  enum class Outcome { solved, not_finite, solver_failed, no_convergence };

  /// `report`, which outlives this, is counted in.
  ImplicitStage(const MechanicalSystem& system, const IntegratorOptions& options, RunReport& report);

  /// Chooses contacts; shifts are zero then.
  void choose(const std::vector<std::size_t>& contacts);
  const StepContacts& contacts() const { return contacts_; }
  /// [m/s] of chosen contact k.
  void set_shift(std::size_t k, double shift) { shift_[static_cast<Eigen::Index>(k)] = shift; }

  /// `u`: the guess on entry. Forces of the last stage in which a contact was chosen are the guess of Λ.
  Outcome solve(const Base& base, Eigen::VectorXd& q, Eigen::VectorXd& u);
  /// An impact alone: u ← u + M⁻¹WΛ at (t, q) with the same laws. It has no duration and so no λ_N: a contact
  /// radius that follows the load is that of the largest load in Hertz's elastic impact of the mass 1/W_NN
  /// with −γ_N (LoadRadius::impact_load), but no smaller than before in a contact that was closed.
  Outcome impact(double t, const Eigen::VectorXd& q, Eigen::VectorXd& u);
  /// Says that a contact was open, so that no load is left from before.
  void forget_load(std::size_t contact);
  /// One line for an outcome that is not `solved`.
  static std::string describe(Outcome outcome);

  // Of the last stage solved, rows of contacts() in order:
  const Eigen::VectorXd& impulse() const { return impulse_; }  ///< Λ
  const Eigen::VectorXd& gamma() const { return gamma_; }      ///< γ
  /// What contacts taken for point contacts leave out.
  double left_out(std::size_t k) const { return points_.left_out(k); }
  /// What chosen contact k is: open where it moves off, γ_N > 0; sticking where γ_F is zero. `Zero` is
  /// what the solver leaves uncertain: ten of its tolerances (or of the residual reached) of the problem's
  /// largest velocity.
  ContactMode mode(std::size_t k) const;

 private:
  Outcome iterate(const Base& base, Eigen::VectorXd& q, Eigen::VectorXd& u);
  void take_for_points();
  Outcome solve_inclusion(double t, const Eigen::VectorXd& q, Eigen::VectorXd& u);
  void follow_loads(double w);
  void follow_impact(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u);
  double effect_of_radii(double w) const;
  bool settled(int round);

  const MechanicalSystem& system_;
  RunReport& report_;
  double tolerance_;
  ContactSolver solver_;
  StepContacts contacts_;
  PointContacts points_;
  Eigen::VectorXd scale_;  ///< of coordinates
  Eigen::VectorXd shift_;
  std::vector<Eigen::Vector4d> force_;  ///< λ of each contact of the system: guesses
  Eigen::VectorXd impulse_, gamma_;
  Eigen::VectorXd free_, rates_, q_change_, u_before_, u_change_, u_guess_;
  double radii_change_ = 0;  ///< what it does to velocities, in units of the largest
  double last_change_ = 0;
  double residual_ = 0;   ///< of the last inclusion
  double uncertain_ = 0;  ///< velocity that counts as zero [m/s]
};

}  // namespace contensou
