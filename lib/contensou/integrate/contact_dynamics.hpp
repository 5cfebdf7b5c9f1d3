#pragma once

#include <vector>

#include "contensou/integrate/constraint_solver.hpp"
#include "contensou/integrate/motion.hpp"
#include "contensou/integrate/ode.hpp"
#include "contensou/integrate/slip_friction.hpp"

namespace contensou {

/// The friction of a contact as a motion has it: none where μ = 0.
const AnyFriction& effective_friction(const SystemContact& contact);

/// The motion between events as an ordinary differential equation: which contacts are open, slip or stick is
/// fixed, and so LG03 (4.1) with contact and friction on acceleration level is a linear system for the
/// forces:
///     closed:    γ̇_N = 0, λ_N of either sign (the event's business);
///     slipping:  λ_F = −μλ_N x̂(γ_F);      sticking:  γ̇_F = 0.
/// Dependent constraints (two contacts that stick) share their forces as ConstraintSolver says.
///
///     y = (q, u, W),    W = (∫ sliding, ∫ drilling power lost) of each contact in turn, then the system's
///                       works() and, if it is driven(), −∫λ·w̃ dt of each contact [J]: quadratures.
///
/// Keeps what its last evaluation found. No allocation after the modes have been met once.
class ContactDynamics final : public OdeSystem {
 public:
  explicit ContactDynamics(const MechanicalSystem& system);

  const MechanicalSystem& system() const { return system_; }
  std::size_t contacts() const { return rows_.size(); }
  Eigen::Index coordinates() const { return n_; }
  Eigen::Index velocities() const { return f_; }

  void set_modes(const std::vector<ContactMode>& modes);

  Eigen::Index size() const override { return driven_ + (drives_ ? count() : 0); }
  Eigen::Index coupled() const override { return n_ + f_; }
  void derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) override;
  /// ∂x̂/∂γ_F from the law, all else by forward differences with x̂ held: exact to some 1e-7 however small
  /// γ_F is.
  void jacobian(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                Eigen::MatrixXd& jacobian) override;
  std::int64_t evaluations() const { return evaluations_; }
  /// Writes the quadratures of y into `dissipated` (by contact, `impact` left alone) and `work`.
  void read_energy(const Eigen::VectorXd& y, std::vector<Dissipation>& dissipated,
                   std::vector<double>& work) const;

  // Of the last evaluation:
  /// λ = (λ_N, λ_T1, λ_T2, λ_τ) [N] of a closed contact.
  const Eigen::Vector4d& force(std::size_t contact) const { return force_[contact]; }
  const ContactRows& rows(std::size_t contact) const { return rows_[contact]; }
  const SlipFriction& friction(std::size_t contact) const { return friction_[contact]; }
  /// γ̇ [m/s²] of a closed contact.
  Eigen::Vector4d contact_acceleration(std::size_t contact, const Eigen::VectorXd& dy) const;
  /// The fastest rate at which friction of one contact brings its slip to equilibrium [1/s], an upper bound:
  /// the largest sum of a row of μλ_N |W_FF ∂x̂/∂γ_F|, over all contacts. 0 without slip.
  double relaxation_rate() const;
  /// Whether friction is about to drive a slipping contact into the floor, however it is pressed: its
  /// w_Nᵀ M⁻¹ (w_N − μ W_F x̂) is not positive, or next to nothing (Painlevé's paradox).
  bool paradox() const;

 private:
  void evaluate(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy);
  void solve_one(Eigen::Ref<Eigen::VectorXd> a);
  void solve_all(Eigen::Ref<Eigen::VectorXd> a);
  /// Direction in which the force of contact i with λ_N = 1 accelerates, while it slips.
  void slip_response(std::size_t contact);
  /// −λ·w̃ of a closed contact.
  double driving_power(std::size_t contact, const Eigen::VectorXd& y) const;
  Eigen::Index count() const { return static_cast<Eigen::Index>(rows_.size()); }

  const MechanicalSystem& system_;
  Eigen::Index n_, f_;
  Eigen::Index works_;            ///< how many
  bool drives_;                   ///< system.driven()
  Eigen::Index worked_, driven_;  ///< where quadratures of works() and of w̃ stand in y
  std::vector<SlipFriction> friction_;
  std::vector<double> mu_;
  std::vector<ContactMode> modes_;
  std::vector<std::size_t> closed_;
  std::vector<Eigen::Vector3d> border_;  ///< x̂ of slipping contacts
  bool border_held_ = false;
  std::vector<ContactRows> rows_;
  std::vector<Eigen::Vector4d> force_;
  std::vector<Eigen::VectorXd> response_;  ///< of slipping contacts
  std::int64_t evaluations_ = 0;

  /// One constraint of solve_all.
  struct Constraint {
    std::size_t contact;
    int row;
  };
  std::vector<Constraint> constraints_;
  ConstraintSolver solver_;

  // Of jacobian().
  Eigen::VectorXd moved_, moved_rate_;
  std::vector<Eigen::MatrixXd> velocity_gradient_;  ///< ∂γ_F/∂(q, u), 3 × (n + f)
  std::vector<Eigen::Vector3d> velocity_;
  Eigen::RowVectorXd border_gradient_;
};

}  // namespace contensou
