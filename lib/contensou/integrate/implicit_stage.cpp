#include "contensou/integrate/implicit_stage.hpp"

#include <algorithm>
#include <cmath>
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
      points_(system, options),
      scale_(system.coordinates()),
      force_(system.contacts().size(), Eigen::Vector4d::Zero()),
      free_(system.velocities()),
      rates_(system.coordinates()),
      u_before_(system.velocities()),
      u_change_(system.velocities()) {
  system.coordinate_scales(scale_);
}

void ImplicitStage::choose(const std::vector<std::size_t>& contacts) {
  if (points_.asked_for() && contacts != contacts_.chosen()) points_.forget(contacts.size());
  contacts_.choose(contacts);
  shift_.setZero(static_cast<Eigen::Index>(contacts.size()));
  impulse_.resize(contacts_.rows());
  gamma_.resize(contacts_.rows());
}

ImplicitStage::Outcome ImplicitStage::solve(const Base& base, Eigen::VectorXd& q, Eigen::VectorXd& u) {
  if (!points_.asked_for()) return iterate(base, q, u);
  const auto holds = [&] { return points_.hold(contacts_, base.w, u, impulse_, gamma_, uncertain_); };
  points_.find(contacts_, base.t, base.q, u, force_);
  take_for_points();
  u_guess_ = u;
  Outcome outcome = iterate(base, q, u);
  if (outcome == Outcome::solved && holds()) return outcome;
  if (!points_.any()) return outcome;
  points_.take_none();
  take_for_points();
  u = u_guess_;
  outcome = iterate(base, q, u);
  if (outcome == Outcome::solved) holds();
  return outcome;
}

ImplicitStage::Outcome ImplicitStage::iterate(const Base& base, Eigen::VectorXd& q, Eigen::VectorXd& u) {
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
      follow_loads(base.w);
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
    radii_change_ = effect_of_radii(base.w);
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
  if (points_.asked_for()) {
    points_.forget(contacts_.chosen().size());
    take_for_points();
  }
  impulse_.setZero();
  if (!contacts_.load_dependent().empty()) follow_impact(t, q, u);
  const Outcome outcome = solve_inclusion(t, q, u);
  if (outcome != Outcome::solved) return outcome;
  if (!u.allFinite()) return Outcome::not_finite;
  contacts_.velocity(u, gamma_);
  report_.worst_residual = std::max(report_.worst_residual, residual_);
  return outcome;
}

void ImplicitStage::take_for_points() {
  contacts_.take_for_points(points_.points());
  impulse_.resize(contacts_.rows());
  gamma_.resize(contacts_.rows());
}

/// Radii of the loads that Λ says.
void ImplicitStage::follow_loads(double w) {
  for (const std::size_t k : contacts_.load_dependent())
    contacts_.set_radius(k, contacts_.load_radius(k).at(impulse_[contacts_.row(k)] / w));
}

/// Radii of Hertz's impact of each contact alone, with the velocity u before it.
void ImplicitStage::follow_impact(double t, const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
  contacts_.evaluate(t, q);
  contacts_.velocity(u, gamma_);
  for (const std::size_t k : contacts_.load_dependent()) {
    const Eigen::Index normal = contacts_.row(k);
    const double mass = 1 / contacts_.problem().delassus(normal, normal);
    const double load = contacts_.load_radius(k).impact_load(mass, -gamma_[normal]);
    const double before = force_[contacts_.chosen()[k]][0];
    contacts_.set_radius(k, contacts_.load_radius(k).at(std::max(load, before)));
  }
}

void ImplicitStage::forget_load(std::size_t contact) {
  if (follows_load(system_.contacts()[contact])) force_[contact].setZero();
}

/// How far radii are from those of the loads found: what friction as large as μΛ_N, turned by as much, does
/// to velocities, in units of the largest or of what Λ_N does.
double ImplicitStage::effect_of_radii(double w) const {
  double largest = 0;
  for (const std::size_t k : contacts_.load_dependent()) {
    const Eigen::Index row = contacts_.row(k);
    const double normal = impulse_[row];
    const double now = contacts_.load_radius(k).at(normal / w);
    const double change = std::abs(now - contacts_.radius(k));
    if (change == 0) continue;
    const auto response = contacts_.response().middleCols(row, 4).cwiseAbs();
    const double by_friction =
        system_.contacts()[contacts_.chosen()[k]].mu * response.rightCols(3).maxCoeff();
    const double speed = u_before_.lpNorm<Eigen::Infinity>() + normal * response.col(0).maxCoeff();
    largest = std::max(largest, change / std::max(now, contacts_.radius(k)) * by_friction * (normal / speed));
  }
  return largest;
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
  const double change = std::max({of_q, of_u, radii_change_});
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
