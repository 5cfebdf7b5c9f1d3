#include "contensou/integrate/moreau_step.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contensou/integrate/motion_recorder.hpp"

namespace contensou {
namespace {

/// γ of the L-stable SDIRK method of order two.
constexpr double diagonal = 1 - std::numbers::sqrt2 / 2;
/// (1 − γ)/γ: how much of what the first stage changed goes into the second one's base.
constexpr double carried = (1 - diagonal) / diagonal;

// Parts of a step that are not worth a step of their own, whose velocities would differ by rounding.
constexpr double negligible = 1e-9;

// Gaps of closed contacts are brought below this part of length_scale (rounding of coordinates), by sweeps
// over the contacts that each take the last one's square, or a fixed part where contacts pull at each other.
constexpr double closed_gap = 0x1p-50;
constexpr int most_sweeps = 6;

}  // namespace

MoreauStep::MoreauStep(const MechanicalSystem& system, const IntegratorOptions& options, Kind kind,
                       RunReport& report)
    : system_(system),
      kind_(kind),
      stage_(system, options, report),
      accounts_(system),
      contact_(system.velocities()),
      acceleration_(Eigen::VectorXd::Zero(system.velocities())),
      first_acceleration_(system.velocities()),
      jerk_(Eigen::VectorXd::Zero(system.velocities())),
      rates_(system.coordinates()),
      rates_start_(system.coordinates()),
      rates_end_(system.coordinates()) {
  end_.modes.assign(system.contacts().size(), ContactMode::open);
  closed_.reserve(system.contacts().size());
  landings_.reserve(system.contacts().size());
  bounced_.reserve(system.contacts().size());
  left_open_.reserve(system.contacts().size());
}

MoreauStep::Outcome MoreauStep::attempt(double t, const ContactState& start, double dt) {
  dt_ = dt;
  q_start_ = start.q;
  u_start_ = start.u;
  system_.coordinate_rates(start.q, start.u, rates_start_);
  landed_ = 1;
  bounced_.clear();
  suppressed_ = false;
  Outcome outcome = fly(t, start, dt);
  if (outcome != Outcome::solved) return outcome;
  find_landings(t, start, dt);
  if (!landings_.empty()) outcome = land(t, start, dt);
  if (outcome != Outcome::solved) return outcome;
  close_gaps(t + dt);
  system_.coordinate_rates(end_.q, end_.u, rates_end_);
  return Outcome::solved;
}

/// The step with the contacts that are closed at its start.
MoreauStep::Outcome MoreauStep::fly(double t, const ContactState& start, double dt) {
  closed_.clear();
  for (std::size_t i = 0; i < start.modes.size(); ++i) {
    if (start.modes[i] != ContactMode::open) closed_.push_back(i);
  }
  stage_.choose(closed_);
  accounts_.clear();
  if (kind_ == Kind::second_order) {
    const Outcome outcome = second_order(t, start, dt);
    if (outcome != Outcome::solved || smooth_) return outcome;
    accounts_.clear();
  }
  const Outcome outcome = euler(t, start, dt);
  if (outcome != Outcome::solved) return outcome;
  acceleration_ = (end_.u - start.u) / dt;
  jerk_.setZero();
  accounts_.add_impulses(stage_, start.u, false);
  accounts_.add_work(t + dt, dt, end_.q, start.u, end_.u);
  return outcome;
}

/// u₁ = u + γΔt a₁; u_E = u + (1 − γ)Δt a₁ + γΔt a₂, and so for q.
MoreauStep::Outcome MoreauStep::second_order(double t, const ContactState& start, double dt) {
  const double w = diagonal * dt;
  u1_ = start.u + w * (acceleration_ + w * jerk_);
  Outcome outcome = stage_.solve({t + w, w, start.q, start.u}, q1_, u1_);
  if (outcome != Outcome::solved) return outcome;
  read_modes();
  smooth_ = end_.modes == start.modes;
  accounts_.add_power(stage_, carried);
  accounts_.add_work(t + w, carried * w, q1_, u1_, u1_);

  q_base_ = start.q + carried * (q1_ - start.q);
  u_base_ = start.u + carried * (u1_ - start.u);
  // Guess: a₂ from a at the start and a₁, on a line.
  first_acceleration_ = (u1_ - start.u) / w;
  end_.u = u_base_ + w * (first_acceleration_ + carried * (first_acceleration_ - acceleration_));
  outcome = stage_.solve({t + dt, w, q_base_, u_base_}, end_.q, end_.u);
  if (outcome != Outcome::solved) return outcome;
  read_modes();
  smooth_ = smooth_ && end_.modes == start.modes;
  accounts_.add_power(stage_, 1);
  accounts_.add_work(t + dt, w, end_.q, end_.u, end_.u);
  acceleration_ = (end_.u - u_base_) / w;
  jerk_ = (acceleration_ - first_acceleration_) / (dt - w);
  return outcome;
}

MoreauStep::Outcome MoreauStep::euler(double t, const ContactState& start, double dt) {
  end_.u = start.u + dt * acceleration_;
  const Outcome outcome = stage_.solve({t + dt, dt, start.q, start.u}, end_.q, end_.u);
  if (outcome != Outcome::solved) return outcome;
  read_modes();
  smooth_ = end_.modes == start.modes;
  return outcome;
}

/// Contacts that are open and in the floor at the end of the step as it stands.
void MoreauStep::find_landings(double t, const ContactState& start, double dt) {
  landings_.clear();
  for (std::size_t i = 0; i < start.modes.size(); ++i) {
    if (start.modes[i] != ContactMode::open) continue;
    const double after = system_.gap(i, t + dt, end_.q);
    if (!(after < 0)) continue;
    const double before = system_.gap(i, t, start.q);
    const double when = before > 0 ? before / (before - after) : 0;
    const double change =
        normal_velocity(i, t + dt, end_.q, end_.u) - normal_velocity(i, t, start.q, start.u);
    landings_.push_back({i, when, change});
  }
}

/// The step up to the first landing, the impact, and backward Euler over what is left, with all contacts that
/// were closed or landed.
MoreauStep::Outcome MoreauStep::land(double t, const ContactState& start, double dt) {
  landed_ = 1;
  for (const Landing& landing : landings_) landed_ = std::min(landed_, landing.when);
  if (landed_ < negligible) landed_ = 0;
  before_impact_ = start;
  if (landed_ > 0) {
    const Outcome outcome = fly(t, start, landed_ * dt);
    if (outcome != Outcome::solved) return outcome;
    before_impact_ = end_;
  } else {
    accounts_.clear();
  }

  for (const Landing& landing : landings_) {
    closed_.push_back(landing.contact);
    stage_.forget_load(landing.contact);
  }
  std::sort(closed_.begin(), closed_.end());
  stage_.choose(closed_);
  const double t_impact = t + landed_ * dt;
  for (const Landing& landing : landings_) {
    // Newton's law. A bounce that the smooth forces of one step end is none.
    const double approach = normal_velocity(landing.contact, t_impact, before_impact_.q, before_impact_.u);
    const double bounce = -system_.contacts()[landing.contact].restitution * approach;
    if (!(bounce > std::abs(landing.change))) {
      suppressed_ = suppressed_ || bounce > 0;
      continue;
    }
    const auto k = std::find(closed_.begin(), closed_.end(), landing.contact) - closed_.begin();
    stage_.set_shift(static_cast<std::size_t>(k), bounce);
  }
  u_after_impact_ = before_impact_.u;
  Outcome outcome = stage_.impact(t_impact, before_impact_.q, u_after_impact_);
  if (outcome != Outcome::solved) return outcome;
  accounts_.add_impulses(stage_, before_impact_.u, true);
  for (const Landing& landing : landings_) {
    const auto k = std::find(closed_.begin(), closed_.end(), landing.contact) - closed_.begin();
    if (stage_.impulse()[stage_.contacts().row(static_cast<std::size_t>(k))] > 0)
      bounced_.push_back(landing.contact);
  }

  left_open_.clear();
  for (std::size_t k = 0; k < closed_.size(); ++k) {
    if (stage_.mode(k) == ContactMode::open) left_open_.push_back(closed_[k]);
  }

  stage_.choose(closed_);
  const double rest = 1 - landed_ < negligible ? 0 : (1 - landed_) * dt;
  end_.q = before_impact_.q;
  end_.u = u_after_impact_;
  if (rest > 0) {
    end_.u += rest * acceleration_;
    outcome = stage_.solve({t + dt, rest, before_impact_.q, u_after_impact_}, end_.q, end_.u);
    if (outcome != Outcome::solved) return outcome;
    accounts_.add_impulses(stage_, u_after_impact_, true);
    accounts_.add_work(t + dt, rest, end_.q, u_after_impact_, end_.u);
  }
  read_modes();
  smooth_ = false;
  for (const std::size_t i : left_open_) suppressed_ = suppressed_ || end_.modes[i] != ContactMode::open;
  std::erase_if(bounced_, [&](std::size_t i) { return end_.modes[i] != ContactMode::open; });
  return outcome;
}

void MoreauStep::read_modes() {
  std::fill(end_.modes.begin(), end_.modes.end(), ContactMode::open);
  for (std::size_t k = 0; k < closed_.size(); ++k) end_.modes[closed_[k]] = stage_.mode(k);
}

double MoreauStep::normal_velocity(std::size_t contact, double t, const Eigen::VectorXd& q,
                                   const Eigen::VectorXd& u) {
  system_.contact_rows(contact, t, q, u, contact_);
  return contact_.velocity[0];
}

/// q of the end restored, and onto g_N = 0 of all closed contacts by changes along M⁻¹w_N.
void MoreauStep::close_gaps(double t) {
  const double good = closed_gap * system_.length_scale();
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    system_.restore(end_.q);
    bool done = true;
    for (std::size_t i = 0; i < end_.modes.size(); ++i) {
      if (end_.modes[i] == ContactMode::open) continue;
      const double gap = system_.gap(i, t, end_.q);
      if (std::abs(gap) <= good) continue;
      done = false;
      system_.contact_rows(i, t, end_.q, end_.u, contact_);
      const double mobility = contact_.directions.col(0).dot(contact_.response.col(0));
      if (!(mobility > 0)) continue;
      system_.coordinate_rates(end_.q, contact_.response.col(0), rates_);
      end_.q -= gap / mobility * rates_;
    }
    if (done) return;
  }
  system_.restore(end_.q);
}

void MoreauStep::interpolate(double theta, Eigen::VectorXd& q, Eigen::VectorXd& u) const {
  if (landed_ < 1) {
    const bool before = theta < landed_;
    const double part = before ? theta / landed_ : (theta - landed_) / (1 - landed_);
    const Eigen::VectorXd& q0 = before ? q_start_ : before_impact_.q;
    const Eigen::VectorXd& u0 = before ? u_start_ : u_after_impact_;
    q = q0 + part * ((before ? before_impact_.q : end_.q) - q0);
    u = u0 + part * ((before ? before_impact_.u : end_.u) - u0);
    return;
  }
  u = u_start_ + theta * (end_.u - u_start_);
  const double back = 1 - theta;
  q = (1 + 2 * theta) * back * back * q_start_ + (1 + 2 * back) * theta * theta * end_.q +
      dt_ * theta * back * (back * rates_start_ - theta * rates_end_);
}

RunReport& end_run(RunReport& report, MoreauStep::Outcome outcome, double t) {
  const bool lost = outcome == MoreauStep::Outcome::not_finite;
  return end_run(report, lost ? RunStatus::not_finite : RunStatus::solver_failed, t,
                 ImplicitStage::describe(outcome));
}

}  // namespace contensou
