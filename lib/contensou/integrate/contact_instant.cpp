#include "contensou/integrate/contact_instant.hpp"

#include <algorithm>
#include <cmath>

#include "contensou/integrate/motion_scales.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

/// A force this near to the border of its domain, relative to its size, is on it: contact problems are
/// solved to 1e-12 of their largest term.
constexpr double on_border = 1e-10;
/// Nor do accelerations differ from zero by less, relative to the largest without contacts.
constexpr double no_acceleration = 1e-10;
/// Of the slip at which contacts are started: a contact that is to stick and moves by more was asked for two
/// things at once.
constexpr double contradicted = 0.1;

}  // namespace

ContactInstant::ContactInstant(const MechanicalSystem& system, double solver_tolerance)
    : system_(system), drives_(system.driven()), solver_(SolverOptions{.tolerance = solver_tolerance}) {
  const std::size_t count = system.contacts().size();
  for (const SystemContact& contact : system.contacts()) friction_.emplace_back(effective_friction(contact));
  rows_.assign(count, ContactRows(system.velocities()));
  at_rest_.assign(count, false);
  struck_.assign(count, false);
  closed_.reserve(count);
  still_.reserve(count);
  targets_.reserve(4 * count);
  move_.resize(system.velocities());
  rates_.resize(system.coordinates());
}

void ContactInstant::gather(const State& state, const std::vector<ContactMode>& modes) {
  closed_.clear();
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] == ContactMode::open) continue;
    closed_.push_back(i);
    system_.contact_rows(i, state.t, state.q, state.u, rows_[i]);
  }
}

/// Groups of one contact each, in the order of closed_, and W = W_allᵀM⁻¹W_all.
void ContactInstant::set_up(ContactProblem& problem) const {
  problem.groups.clear();
  std::vector<std::pair<std::size_t, int>> index;
  for (const std::size_t i : closed_) {
    const SystemContact& contact = system_.contacts()[i];
    problem.groups.push_back({&effective_friction(contact), {contact.mu}});
    for (int k = 0; k <= friction_[i].dimension(); ++k) index.emplace_back(i, k);
  }
  const auto m = static_cast<Eigen::Index>(index.size());
  problem.delassus.resize(m, m);
  problem.free_velocity.setZero(m);
  for (Eigen::Index r = 0; r < m; ++r) {
    const auto [i, k] = index[static_cast<std::size_t>(r)];
    for (Eigen::Index s = 0; s <= r; ++s) {
      const auto [j, l] = index[static_cast<std::size_t>(s)];
      problem.delassus(r, s) = problem.delassus(s, r) =
          rows_[i].directions.col(k).dot(rows_[j].response.col(l));
    }
  }
}

bool ContactInstant::solved(const SolverReport& solver, const State& state, const char* what,
                            RunReport& report) const {
  ++report.contact_problems;
  report.contact_iterations += solver.iterations;
  report.worst_residual = std::max(report.worst_residual, solver.residual);
  if (solver.status == SolverStatus::solved || solver.status == SolverStatus::at_rounding) return true;
  report.status = RunStatus::solver_failed;
  report.message = std::string(what) + " at t = " + to_text(state.t) + " s: no solution found, residual " +
                   to_text(solver.residual);
  return false;
}

bool ContactInstant::finite(const ContactProblem& problem, const State& state, RunReport& report) const {
  if (problem.delassus.allFinite() && problem.free_velocity.allFinite()) return true;
  report.status = RunStatus::not_finite;
  report.message = "the contacts' terms are not finite at t = " + to_text(state.t) + " s";
  return false;
}

bool ContactInstant::impact(State& state, const InstantTolerances& tolerances, RunReport& report) {
  const bool any = std::any_of(closed_.begin(), closed_.end(),
                               [&](std::size_t i) { return rows_[i].velocity[0] < -tolerances.approach; });
  if (!any) return true;
  ContactProblem problem;
  set_up(problem);
  Eigen::Index row = 0;
  for (const std::size_t i : closed_) {
    const int count = 1 + friction_[i].dimension();
    problem.free_velocity.segment(row, count) = rows_[i].velocity.head(count);
    problem.free_velocity[row] *= 1 + system_.contacts()[i].restitution;
    row += count;
  }
  if (!finite(problem, state, report)) return false;
  Eigen::VectorXd impulse;
  if (!solved(solver_.solve(problem, impulse), state, "impact", report)) return false;
  const Eigen::VectorXd change = problem.delassus * impulse;
  if (drives_) {
    row = 0;
    for (const std::size_t i : closed_) {
      for (int k = 0; k <= friction_[i].dimension(); ++k)
        report.dissipated[i].driven -= impulse[row++] * rows_[i].given(k, state.u);
    }
  }
  row = 0;
  for (const std::size_t i : closed_) {
    const int count = 1 + friction_[i].dimension();
    const auto part = impulse.segment(row, count);
    const auto before = rows_[i].velocity.head(count);
    report.dissipated[i].impact -= part.dot(before + change.segment(row, count) / 2);
    struck_[i] = before[0] < -tolerances.approach;
    state.u += rows_[i].response.leftCols(count) * part;
    row += count;
  }
  return true;
}

void ContactInstant::drop_departed(const State& state, std::vector<ContactMode>& modes,
                                   const InstantTolerances& tolerances) {
  const bool any_struck = std::find(struck_.begin(), struck_.end(), true) != struck_.end();
  for (const std::size_t i : closed_) {
    if (rows_[i].velocity[0] > (any_struck ? tolerances.bounce : tolerances.approach))
      modes[i] = ContactMode::open;
  }
  gather(state, modes);
}

/// Changes u by the least kinetic norm so that the targets hold: u += M⁻¹W Λ, WᵀM⁻¹W Λ = target − γ.
void ContactInstant::apply(State& state, RunReport& report) {
  const auto m = static_cast<Eigen::Index>(targets_.size());
  constraints_.resize(m);
  bool met = true;
  for (Eigen::Index r = 0; r < m; ++r) {
    Target& a = targets_[static_cast<std::size_t>(r)];
    if (drives_) a.given = rows_[a.contact].given(a.row, state.u);
    for (Eigen::Index s = 0; s < m; ++s) {
      const Target& b = targets_[static_cast<std::size_t>(s)];
      constraints_.matrix(r, s) =
          rows_[a.contact].directions.col(a.row).dot(rows_[b.contact].response.col(b.row));
    }
    constraints_.side[r] = a.velocity - rows_[a.contact].velocity[a.row];
    met = met && constraints_.side[r] == 0;
  }
  if (met) return;
  const Eigen::VectorXd& impulse = constraints_.solve();
  for (Eigen::Index r = 0; r < m; ++r) {
    const Target& a = targets_[static_cast<std::size_t>(r)];
    const double mean = (rows_[a.contact].velocity[a.row] + a.velocity) / 2;
    report.dissipated[a.contact].impact -= impulse[r] * mean;
    report.dissipated[a.contact].driven -= impulse[r] * a.given;
    state.u += impulse[r] * rows_[a.contact].response.col(a.row);
  }
}

void ContactInstant::stop_slow_slip(State& state, const InstantTolerances& tolerances, RunReport& report) {
  targets_.clear();
  for (const std::size_t i : closed_) {
    targets_.push_back({i, 0, 0.0});
    const double factor = spin_factor(system_.contacts()[i], tolerances.length);
    at_rest_[i] = friction_[i].dimension() > 0 && slip_speed(rows_[i].velocity, factor) <= tolerances.slip;
    if (!at_rest_[i]) continue;
    for (int k = 1; k <= friction_[i].dimension(); ++k) targets_.push_back({i, k, 0.0});
  }
  apply(state, report);
}

bool ContactInstant::decide(State& state, std::vector<ContactMode>& modes,
                            const InstantTolerances& tolerances, RunReport& report) {
  gather(state, modes);
  if (closed_.empty()) return true;
  ContactProblem full;
  set_up(full);
  Eigen::VectorXd free(system_.velocities());
  system_.free_acceleration(state.t, state.q, state.u, free);
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(full.rows());
  Eigen::Index row = 0;
  for (const std::size_t i : closed_) {
    const int count = 1 + friction_[i].dimension();
    full.free_velocity.segment(row, count) =
        rows_[i].directions.leftCols(count).transpose() * free + rows_[i].drift.head(count);
    if (!at_rest_[i]) velocity.segment(row, count) = rows_[i].velocity.head(count);
    row += count;
  }
  if (!finite(full, state, report)) return false;
  const AccelerationLevel level(full, velocity);
  Eigen::VectorXd reduced;
  if (!solved(solver_.solve(level.problem(), reduced), state, "forces of closed contacts", report)) {
    if (level.paradox()) report.message += " (Painleve's paradox)";
    return false;
  }
  const Eigen::VectorXd forces = level.forces(reduced);
  const Eigen::VectorXd change = full.delassus * forces + full.free_velocity;
  const double no_change = no_acceleration * full.free_velocity.lpNorm<Eigen::Infinity>();

  targets_.clear();
  still_.clear();
  row = 0;
  for (const std::size_t i : closed_) {
    const int dimension = friction_[i].dimension();
    const double normal = forces[row];
    Eigen::Vector3d friction = Eigen::Vector3d::Zero();
    friction.head(dimension) = forces.segment(row + 1, dimension);
    const double slip_change = change.segment(row + 1, dimension).norm();
    row += 1 + dimension;
    modes[i] = ContactMode::slip;
    if (!(normal > 0)) {
      modes[i] = ContactMode::open;
      continue;
    }
    targets_.push_back({i, 0, 0.0});
    if (!at_rest_[i]) continue;
    const double size = system_.contacts()[i].mu * normal;
    const bool holds = friction_[i].gauge(friction) < size * (1 - on_border);
    if (holds) modes[i] = ContactMode::stick;
    if (!holds && slip_change <= no_change) still_.push_back(i);
    Eigen::Vector3d start = Eigen::Vector3d::Zero();
    if (!holds) {
      start = -friction_[i].normal(friction);
      const double factor = spin_factor(system_.contacts()[i], tolerances.length);
      start *= 2 * tolerances.slip / slip_speed({0, start[0], start[1], start[2]}, factor);
    }
    for (int k = 0; k < dimension; ++k) targets_.push_back({i, k + 1, start[k]});
  }
  apply(state, report);
  hold_still(state, modes, tolerances, report);

  // Another contact that sticks may leave a slip no room (a cone that rolls on two spheres): then this one
  // sticks, too, and the two share their forces.
  gather(state, modes);
  for (const std::size_t i : closed_) {
    if (modes[i] == ContactMode::slip && at_rest_[i] && !slips(i, tolerances)) modes[i] = ContactMode::stick;
  }
  return true;
}

bool ContactInstant::slips(std::size_t contact, const InstantTolerances& tolerances, double part) const {
  const double factor = spin_factor(system_.contacts()[contact], tolerances.length);
  return slip_speed(rows_[contact].velocity, factor) > part * tolerances.slip;
}

void ContactInstant::hold_still(State& state, std::vector<ContactMode>& modes,
                                const InstantTolerances& tolerances, RunReport& report) {
  if (still_.empty()) return;
  gather(state, modes);
  const bool moved = std::any_of(closed_.begin(), closed_.end(), [&](std::size_t i) {
    return modes[i] == ContactMode::stick && slips(i, tolerances, contradicted);
  });
  if (!moved) return;
  for (const std::size_t i : still_) modes[i] = ContactMode::stick;
  correct_velocities(state, modes, report);
}

bool ContactInstant::settle(State& state, std::vector<ContactMode>& modes,
                            const InstantTolerances& tolerances, RunReport& report) {
  std::fill(struck_.begin(), struck_.end(), false);
  gather(state, modes);
  if (!impact(state, tolerances, report)) return false;
  gather(state, modes);
  drop_departed(state, modes, tolerances);
  stop_slow_slip(state, tolerances, report);
  return decide(state, modes, tolerances, report);
}

void ContactInstant::close(State& state, const std::vector<ContactMode>& modes, RunReport& report) {
  gather(state, modes);
  const auto m = static_cast<Eigen::Index>(closed_.size());
  constraints_.resize(m);
  // Λ = (1, −μx̂) Λ_N of each contact.
  std::vector<Eigen::Vector4d> ray;
  for (const std::size_t i : closed_) {
    ray.emplace_back(1, 0, 0, 0);
    const Eigen::Vector3d gamma = rows_[i].velocity.tail<3>();
    const int dimension = friction_[i].dimension();
    if (modes[i] == ContactMode::slip && dimension > 0 && !gamma.head(dimension).isZero(0))
      ray.back().tail<3>() = -system_.contacts()[i].mu * friction_[i].border(gamma);
  }
  const auto response = [&](std::size_t r) {
    const int count = 1 + friction_[closed_[r]].dimension();
    return (rows_[closed_[r]].response.leftCols(count) * ray[r].head(count)).eval();
  };
  for (std::size_t s = 0; s < closed_.size(); ++s) {
    const Eigen::VectorXd column = response(s);
    for (std::size_t r = 0; r < closed_.size(); ++r)
      constraints_.matrix(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(s)) =
          rows_[closed_[r]].directions.col(0).dot(column);
    constraints_.side[static_cast<Eigen::Index>(s)] = -rows_[closed_[s]].velocity[0];
  }
  const Eigen::VectorXd impulse = constraints_.solve();
  const Eigen::VectorXd before = state.u;
  for (std::size_t r = 0; r < closed_.size(); ++r)
    state.u += impulse[static_cast<Eigen::Index>(r)] * response(r);
  const Eigen::VectorXd mean = (state.u - before) / 2;
  for (std::size_t r = 0; r < closed_.size(); ++r) {
    const std::size_t i = closed_[r];
    const int count = 1 + friction_[i].dimension();
    const Eigen::VectorXd gamma =
        rows_[i].velocity.head(count) + rows_[i].directions.leftCols(count).transpose() * mean;
    report.dissipated[i].impact -= impulse[static_cast<Eigen::Index>(r)] * ray[r].head(count).dot(gamma);
    for (int k = 0; drives_ && k < count; ++k)
      report.dissipated[i].driven -=
          impulse[static_cast<Eigen::Index>(r)] * ray[r][k] * rows_[i].given(k, before);
  }
}

void ContactInstant::correct_velocities(State& state, const std::vector<ContactMode>& modes,
                                        RunReport& report) {
  gather(state, modes);
  targets_.clear();
  for (const std::size_t i : closed_) {
    targets_.push_back({i, 0, 0.0});
    if (modes[i] != ContactMode::stick) continue;
    for (int k = 1; k <= friction_[i].dimension(); ++k) targets_.push_back({i, k, 0.0});
  }
  apply(state, report);
}

void ContactInstant::correct_positions(State& state, const std::vector<ContactMode>& modes) {
  // Twice: gaps are not linear in q.
  for (int pass = 0; pass < 2; ++pass) {
    gather(state, modes);
    const auto m = static_cast<Eigen::Index>(closed_.size());
    gaps_.resize(m);
    bool met = true;
    for (Eigen::Index r = 0; r < m; ++r) {
      const std::size_t i = closed_[static_cast<std::size_t>(r)];
      gaps_.side[r] = -system_.gap(i, state.t, state.q);
      met = met && gaps_.side[r] == 0;
      for (Eigen::Index s = 0; s < m; ++s)
        gaps_.matrix(r, s) =
            rows_[i].directions.col(0).dot(rows_[closed_[static_cast<std::size_t>(s)]].response.col(0));
    }
    if (met) return;
    const Eigen::VectorXd& amount = gaps_.solve();
    move_.setZero();
    for (Eigen::Index r = 0; r < m; ++r)
      move_ += amount[r] * rows_[closed_[static_cast<std::size_t>(r)]].response.col(0);
    system_.coordinate_rates(state.q, move_, rates_);
    state.q += rates_;
    system_.restore(state.q);
  }
}

}  // namespace contensou
