#include "contensou/integrate/implicit_stage.hpp"

#include <algorithm>
#include <limits>

namespace contensou {
namespace {

constexpr int most_rounds = 60;
// Of coordinates in their scales and of the largest velocity: a few roundings.
constexpr double rounding = 4e-15;
// Below, changes that no longer shrink are the rounding of larger numbers or the solver's tolerance.
constexpr double small = 1e-9;
constexpr double shrinks = 0.5;
constexpr double zero_in_tolerances = 10;

}  // namespace

ImplicitStage::ImplicitStage(const MechanicalSystem& system, const IntegratorOptions& options,
                             RunReport& report)
    : system_(system),
      report_(report),
      tolerance_(options.solver_tolerance),
      solver_({.method = SolverMethod::automatic, .tolerance = options.solver_tolerance}),
      contacts_(system),
      scale_(system.coordinates()),
      force_(system.contacts().size(), Eigen::Vector4d::Zero()),
      free_(system.velocities()),
      rates_(system.coordinates()),
      u_before_(system.velocities()),
      u_change_(system.velocities()) {
  system.coordinate_scales(scale_);
}

void ImplicitStage::choose(const std::vector<std::size_t>& contacts) {
  contacts_.choose(contacts);
  shift_.setZero(static_cast<Eigen::Index>(contacts.size()));
  impulse_.resize(contacts_.rows());
  gamma_.resize(contacts_.rows());
}

ImplicitStage::Outcome ImplicitStage::solve(const Base& base, Eigen::VectorXd& q, Eigen::VectorXd& u) {
  const auto& chosen = contacts_.chosen();
  for (std::size_t k = 0; k < chosen.size(); ++k)
    impulse_.segment(contacts_.row(k), contacts_.rows(k)) =
        base.w * force_[chosen[k]].head(contacts_.rows(k));
  system_.coordinate_rates(base.q, u, rates_);
  q = base.q + base.w * rates_;
  for (int round = 0; round < most_rounds; ++round) {
    u_before_ = u;
    system_.free_acceleration(base.t, q, u_before_, free_);
    ++report_.evaluations;
    u = base.u + base.w * free_;
    if (!chosen.empty()) {
      const Outcome outcome = solve_inclusion(base.t, q, u);
      if (outcome == Outcome::not_finite && round > 0) return Outcome::no_convergence;
      if (outcome != Outcome::solved) return outcome;
    }
    system_.coordinate_rates(q, u, rates_);
    q_change_ = base.q + base.w * rates_ - q;
    q += q_change_;
    // The first round has the system's numbers; later ones may have run away.
    if (!q.allFinite() || !u.allFinite()) return round > 0 ? Outcome::no_convergence : Outcome::not_finite;
    u_change_ = u - u_before_;
    if (!settled(round)) continue;
    contacts_.velocity(u, gamma_);
    if (!chosen.empty()) report_.worst_residual = std::max(report_.worst_residual, residual_);
    for (std::size_t k = 0; k < chosen.size(); ++k)
      force_[chosen[k]].head(contacts_.rows(k)) =
          impulse_.segment(contacts_.row(k), contacts_.rows(k)) / base.w;
    return Outcome::solved;
  }
  return Outcome::no_convergence;
}

ImplicitStage::Outcome ImplicitStage::impact(double t, const Eigen::VectorXd& q, Eigen::VectorXd& u) {
  impulse_.setZero();
  const Outcome outcome = solve_inclusion(t, q, u);
  if (outcome != Outcome::solved) return outcome;
  if (!u.allFinite()) return Outcome::not_finite;
  contacts_.velocity(u, gamma_);
  report_.worst_residual = std::max(report_.worst_residual, residual_);
  return outcome;
}

/// u without contacts on entry, with Λ on return.
ImplicitStage::Outcome ImplicitStage::solve_inclusion(double t, const Eigen::VectorXd& q,
                                                      Eigen::VectorXd& u) {
  contacts_.evaluate(t, q);
  ContactProblem& problem = contacts_.problem();
  contacts_.velocity(u, problem.free_velocity);
  for (std::size_t k = 0; k < contacts_.chosen().size(); ++k)
    problem.free_velocity[contacts_.row(k)] -= shift_[static_cast<Eigen::Index>(k)];
  if (!problem.free_velocity.allFinite() || !problem.delassus.allFinite()) return Outcome::not_finite;
  const SolverReport solved = solver_.solve(problem, impulse_);
  ++report_.contact_problems;
  report_.contact_iterations += solved.iterations;
  if (solved.status != SolverStatus::solved && solved.status != SolverStatus::at_rounding)
    return Outcome::solver_failed;
  residual_ = solved.residual;
  uncertain_ =
      zero_in_tolerances * std::max(tolerance_, residual_) * problem.free_velocity.lpNorm<Eigen::Infinity>();
  u.noalias() += contacts_.response() * impulse_;
  return Outcome::solved;
}

/// Whether the next round will change nothing, shrinking as this one did.
bool ImplicitStage::settled(int round) {
  const double largest = u_before_.lpNorm<Eigen::Infinity>();
  const double of_q = q_change_.cwiseQuotient(scale_).lpNorm<Eigen::Infinity>();
  const double of_u = largest > 0 ? u_change_.lpNorm<Eigen::Infinity>() / largest
                                  : (u_change_.isZero(0) ? 0 : std::numeric_limits<double>::infinity());
  const double change = std::max(of_q, of_u);
  const bool stalls = round > 0 && change <= small && change > shrinks * last_change_;
  const double next = round > 0 && change < last_change_ ? change * (change / last_change_) : change;
  last_change_ = change;
  return next <= rounding || stalls;
}

ContactMode ImplicitStage::mode(std::size_t k) const {
  const Eigen::Index first = contacts_.row(k);
  const Eigen::Index n = contacts_.rows(k);
  if (gamma_[first] > uncertain_) return ContactMode::open;
  const bool sticks = n > 1 && gamma_.segment(first + 1, n - 1).norm() <= uncertain_;
  return sticks ? ContactMode::stick : ContactMode::slip;
}

std::string ImplicitStage::describe(Outcome outcome) {
  switch (outcome) {
    case Outcome::solved:
      return {};
    case Outcome::not_finite:
      return "the next state is not finite";
    case Outcome::solver_failed:
      return "the contact problem was not solved";
    case Outcome::no_convergence:
      return "the step is too long: its equations do not converge";
  }
  return {};
}

}  // namespace contensou
