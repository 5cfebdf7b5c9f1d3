#include "contensou/integrate/hybrid_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "contensou/integrate/schemes.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Relative to the scales of the motion (MotionScales).
constexpr double approach_speed = 1e-11;  ///< beside the rounding of γ_N, 1e-16, and below all that matters
constexpr double slip_at_rest = 1e-11;    ///< likewise, and ...
/// ... times the tolerance: slip so slow that steps through zero pass the error control, which then no longer
/// sees that friction jumps there.
constexpr double slip_unresolved = 50;
/// Bounces shorter than this are summed: five times as long as those no higher than EventSearch resolves ...
constexpr double short_bounce = 5e-6;
/// ... or, times √tolerance, as those no higher than errors are.
constexpr double short_bounce_root = 1;
/// Seven impacts within this many of them are no longer resolved, whatever they look like.
constexpr double unresolved_impacts = 24;
/// A contact that leaves an impact for a bounce shorter than this part of that stays closed.
constexpr double no_bounce = 0.1;
constexpr int most_stalled = 200;
constexpr double next_to_nothing = 200;  ///< smallest steps: so near to rest, slip is settled, not followed
/// Implicit steps are no longer than this: they would damp motions too small for the error control to see,
/// even those that are about to grow (a top that sleeps upright and becomes unstable).
constexpr double longest_implicit = 0.1;

/// What drift from g_N = 0 and γ = 0 is left alone: a tenth of what the error control allows, or roundings.
constexpr double drift_share = 0.1;
constexpr double gap_rounding = 8 * epsilon;
constexpr double speed_rounding = 64 * epsilon;

}  // namespace

HybridRun::HybridRun(const MechanicalSystem& system, State& state, double t_end,
                     const IntegratorOptions& options, const Observer& observer, OdeStep& explicit_step,
                     StepChoice choice)
    : system_(system),
      state_(state),
      t_end_(t_end),
      options_(options),
      observer_(observer),
      explicit_(explicit_step),
      control_(choice, options, state.t),
      dynamics_(system),
      instant_(system, options.solver_tolerance),
      scales_(motion_scales(system, state)),
      clock_(state.t, t_end, options.output_interval),
      modes_(system.contacts().size(), ContactMode::open),
      modes_before_(modes_),
      events_(dynamics_, scales_, modes_),
      impacts_(modes_.size()),
      opened_(modes_.size(), -infinite),
      flight_(modes_.size(), infinite) {
  for (const SystemContact& contact : system.contacts())
    spin_factor_.push_back(contact.mu > 0 ? spin_factor(contact, scales_.length) : 0);
  for (Eigen::VectorXd* v : {&y_, &rate_, &scale_, &shown_}) v->setZero(dynamics_.size());
  shown_q_.resize(dynamics_.coordinates());
  shown_u_.resize(dynamics_.velocities());
  report_.dissipated.assign(modes_.size(), {});

  const double tolerance = choice == StepChoice::adaptive ? options.tolerance : 0;
  shortest_bounce_ = std::max(short_bounce, short_bounce_root * std::sqrt(tolerance)) * scales_.time;
  const double bounce_speed =
      no_bounce * shortest_bounce_ * scales_.length / (scales_.time * scales_.time) / 2;
  tolerances_ = {.approach = approach_speed * scales_.speed,
                 .bounce = bounce_speed,
                 .slip = std::max(slip_at_rest, slip_unresolved * tolerance) * scales_.speed,
                 .length = scales_.length};
  set_error_scales();
}

RunReport HybridRun::run() {
  bool going = start();
  while (going && state_.t < t_end_) {
    going = report_.steps + report_.rejected < options_.max_steps
                ? advance()
                : fail(RunStatus::step_limit,
                       "no more than " + std::to_string(options_.max_steps) + " steps allowed");
  }
  if (going) {
    state_.t = t_end_;  // the last step may have ended a rounding away
    // Whoever goes on from here starts with closed contacts closed.
    instant_.correct_positions(state_, modes_);
    instant_.correct_velocities(state_, modes_, report_);
    load();
    show_until(t_end_, nullptr, 0);
  }
  dynamics_.read_energy(y_, report_.dissipated, report_.work);
  report_.evaluations = dynamics_.evaluations();
  order_events();
  return report_;
}

/// A series of impacts ends a contact's bounces at its limit, a little later than the impact it was seen at.
/// Other contacts' events may lie between; the contact's own are then at the limit, too.
void HybridRun::order_events() {
  std::vector<double> latest(modes_.size(), -infinite);
  for (Event& event : report_.events)
    event.t = latest[event.contact] = std::min(std::max(latest[event.contact], event.t), t_end_);
  std::stable_sort(report_.events.begin(), report_.events.end(),
                   [](const Event& a, const Event& b) { return a.t < b.t; });
}

bool HybridRun::fail(RunStatus status, const std::string& message) {
  report_.status = status;
  report_.message = message + ", at t = " + to_text(state_.t) + " s";
  return false;
}

double HybridRun::smallest_step() const { return 4 * epsilon * std::max(std::abs(state_.t), scales_.time); }

/// Which contacts are closed, and a first step. How it starts is no event, unless by an impact.
bool HybridRun::start() {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (system_.gap(i, state_.t, state_.q) <= closed_at_start * scales_.length) modes_[i] = ContactMode::slip;
  }
  if (!settle("start", state_.t)) return false;
  std::erase_if(report_.events, [this](const Event& event) { return !instant_.struck(event.contact); });
  set_first_step();
  show_until(state_.t, nullptr, 0);
  return true;
}

void HybridRun::set_error_scales() {
  const auto n = dynamics_.coordinates();
  const auto f = dynamics_.velocities();
  scale_.head(n) = options_.tolerance * scales_.coordinate;
  scale_.segment(n, f) = options_.tolerance * scales_.velocity;
  scale_.tail(scale_.size() - n - f).setConstant(options_.tolerance * scales_.energy);
}

/// One in which coordinates and velocities change by a hundredth of their scales.
void HybridRun::set_first_step() {
  const auto n = dynamics_.coupled();
  const double rate = options_.tolerance * (rate_.head(n).array() / scale_.head(n).array()).abs().maxCoeff();
  control_.set_first(0.01 * std::min(scales_.time, rate > 0 ? 1 / rate : infinite));
}

void HybridRun::load() {
  y_.head(dynamics_.coordinates()) = state_.q;
  y_.segment(dynamics_.coordinates(), dynamics_.velocities()) = state_.u;
}

void HybridRun::unload() {
  state_.q = y_.head(dynamics_.coordinates());
  state_.u = y_.segment(dynamics_.coordinates(), dynamics_.velocities());
}

/// What the next step has to know of the last evaluation, which was at y_.
void HybridRun::read_rates() {
  relaxation_ = dynamics_.relaxation_rate();
  time_to_rest_ = infinite;
  slowest_slip_ = infinite;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (modes_[i] != ContactMode::slip || dynamics_.friction(i).dimension() == 0) continue;
    const Eigen::Vector4d& gamma = dynamics_.rows(i).velocity;
    const Eigen::Vector4d change = dynamics_.contact_acceleration(i, rate_);
    const double factor = spin_factor_[i] * spin_factor_[i];
    const double square = gamma[1] * gamma[1] + gamma[2] * gamma[2] + factor * gamma[3] * gamma[3];
    const double fall = gamma[1] * change[1] + gamma[2] * change[2] + factor * gamma[3] * change[3];
    slowest_slip_ = std::min(slowest_slip_, std::sqrt(square));
    if (fall < 0) time_to_rest_ = std::min(time_to_rest_, -square / fall);
  }
}

/// Solves the instant and records what changed, as of time t.
bool HybridRun::settle(const std::string& cause, double t) {
  // First, so that a contact that opens does so at g_N = 0, and that none is thought to move apart that has
  // only drifted.
  instant_.correct_positions(state_, modes_);
  instant_.correct_velocities(state_, modes_before_, report_);
  if (!instant_.settle(state_, modes_, tolerances_, report_)) {
    report_.message += " (" + cause + ")";
    return false;
  }
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const bool was_open = modes_before_[i] == ContactMode::open;
    const bool is_open = modes_[i] == ContactMode::open;
    if (instant_.struck(i) && was_open && is_open) {
      report_.events.push_back({t, EventKind::close, i});
      report_.events.push_back({t, EventKind::open, i});
    }
    record_change(t, i, modes_before_[i], modes_[i], report_.events);
  }
  if (modes_ != modes_before_) events_.watch_all();
  return go_on();
}

/// Makes everything ready for the next step, with the modes as they are.
bool HybridRun::go_on() {
  modes_before_ = modes_;
  events_.disarm_touching(state_.t, state_.q);
  dynamics_.set_modes(modes_);
  load();
  dynamics_.derivative(state_.t, y_, rate_);
  if (!rate_.allFinite()) return fail(RunStatus::not_finite, "the accelerations are not finite");
  read_rates();
  events_.begin(state_.t, y_);
  return true;
}

/// Ends series of impacts that are no longer resolved: the contacts whose series have the same limit close.
bool HybridRun::close_accumulated() {
  const double unresolved = unresolved_impacts * shortest_bounce_;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (instant_.struck(i)) impacts_[i].add(state_.t);
    flight_[i] = state_.t - opened_[i];
    if (events_.fresh(i)) opened_[i] = state_.t;
  }
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (!instant_.struck(i) || flight_[i] > shortest_bounce_) continue;
    const std::optional<double> limit = impacts_[i].limit(unresolved);
    if (!limit) continue;
    const double same = 2 * (*limit - state_.t) + shortest_bounce_;
    std::vector<std::size_t> together;
    for (std::size_t j = 0; j < modes_.size(); ++j) {
      const std::optional<double> other = impacts_[j].limit(unresolved);
      if (!other || std::abs(*other - *limit) > same) continue;
      together.push_back(j);
      if (modes_[j] == ContactMode::open) modes_[j] = ContactMode::slip;
    }
    instant_.close(state_, modes_, report_);
    if (!settle("accumulation of impacts", *limit)) return false;
    for (const std::size_t j : together) {
      report_.events.push_back({*limit, EventKind::accumulation, j});
      impacts_[j].clear();
    }
    return true;
  }
  return true;
}

/// One step, or one event, or an attempt.
bool HybridRun::advance() {
  if (t_end_ - state_.t <= smallest_step()) {
    state_.t = t_end_;
    return true;
  }
  double h = control_.propose(state_.t, t_end_, time_to_rest_);
  if (!(h > smallest_step())) return stop_slip(h);
  OdeStep* method = &explicit_;
  if (control_.implicit(h, relaxation_)) {
    method = &implicit_;
    h = std::min(h, longest_implicit * scales_.time);
  } else {
    // Where even that is next to nothing, slip is about to be settled.
    h = std::min(h, std::max(control_.longest_explicit(relaxation_), next_to_nothing * smallest_step()));
  }
  OdeStep& stepper = *method;
  const double error = stepper.attempt(dynamics_, state_.t, y_, rate_, h, scale_);
  evaluations_ = dynamics_.evaluations();
  if (!control_.acceptable(error)) {
    ++report_.rejected;
    control_.reject(h, error, stepper.error_order());
    return true;
  }
  if (const std::optional<EventSearch::Found> found = events_.find(stepper, state_.t, h))
    return take_event(stepper, h, *found);
  return take_step(stepper, h, error);
}

/// Steps are too short to be told from zero: slip comes to rest within the rounding of t, or nothing helps.
bool HybridRun::stop_slip(double h) {
  if (time_to_rest_ < next_to_nothing * smallest_step() && ++stalled_ <= most_stalled) {
    const double slip = tolerances_.slip;
    tolerances_.slip = std::max(slip, 2 * slowest_slip_);
    const bool settled = settle("slip that came to rest", state_.t);
    tolerances_.slip = slip;
    return settled;
  }
  return fail(RunStatus::step_too_small,
              "a step of " + to_text(h) + " s" + (dynamics_.paradox() ? " (Painleve's paradox)" : ""));
}

bool HybridRun::take_event(OdeStep& stepper, double h, const EventSearch::Found& found) {
  if (found.theta * h > smallest_step()) {
    const std::optional<double> length = events_.land(stepper, state_.t, y_, rate_, h, scale_, found);
    if (!length) {
      ++report_.rejected;
      control_.reject(h, infinite, 1);
      return true;
    }
    record_spins(stepper, *length);
    show_until(state_.t + *length, &stepper, *length);
    ++report_.steps;
    y_ = stepper.end();
    unload();
    system_.restore(state_.q);
    state_.t += *length;
    control_.interrupt(h);
    stalled_ = 0;
  } else if (++stalled_ > most_stalled) {
    return fail(RunStatus::solver_failed, "contacts change their state without end");
  }
  ContactMode& mode = modes_[found.contact];
  const ContactMode before = mode;
  if (mode == ContactMode::open) mode = ContactMode::slip;  // closed, which is what settle() asks
  if (!settle("event", state_.t)) return false;
  if (stalled_ > 0 && mode == before && before != ContactMode::open) return overrule(found);
  return close_accumulated();
}

/// The contact laws see no event where the monitor does: with dependent constraints, forces can be shared in
/// more than one way, and at the border between closed and open roundings decide.
bool HybridRun::overrule(const EventSearch::Found& found) {
  if (found.of_friction) {
    events_.relax(found.contact);
  } else {
    record_change(state_.t, found.contact, modes_[found.contact], ContactMode::open, report_.events);
    modes_[found.contact] = ContactMode::open;
  }
  return go_on();
}

bool HybridRun::take_step(OdeStep& stepper, double h, double error) {
  record_spins(stepper, h);
  show_until(state_.t + h, &stepper, h);
  state_.t = control_.accept(state_.t, h, error, stepper.error_order());
  stalled_ = 0;
  ++report_.steps;
  y_ = stepper.end();
  if (!y_.allFinite()) return fail(RunStatus::not_finite, "the state is no longer finite");
  rate_ = stepper.end_rate();
  // Where the step was looked into, what dynamics_ keeps is no longer of its end.
  if (dynamics_.evaluations() != evaluations_) dynamics_.derivative(state_.t, y_, rate_);
  unload();
  correct_drift();
  read_rates();
  events_.accept(state_.t, y_);
  if (slowest_slip_ <= tolerances_.slip) return settle("slip that came to rest", state_.t);
  if (events_.any_relaxed()) return settle("forces of dependent constraints", state_.t);
  return true;
}

void HybridRun::record_spins(OdeStep& stepper, double h) {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (const std::optional<double> theta = events_.spin_reversal(stepper, state_.t, h, i))
      report_.events.push_back({state_.t + *theta * h, EventKind::spin, i});
  }
}

/// Calls the observer for all sample times up to t; `stepper` holds the step of length h from state_.t.
void HybridRun::show_until(double t, OdeStep* stepper, double h) {
  if (!observer_) return;
  for (; clock_.next() <= t; clock_.advance()) {
    const double at = clock_.next();
    if (stepper == nullptr || at <= state_.t) {
      shown_ = y_;
    } else {
      stepper->interpolate(dynamics_, std::min((at - state_.t) / h, 1.0), shown_);
    }
    shown_q_ = shown_.head(dynamics_.coordinates());
    shown_u_ = shown_.segment(dynamics_.coordinates(), dynamics_.velocities());
    system_.restore(shown_q_);
    observer_({at, shown_q_, shown_u_, modes_});
  }
}

/// Brings coordinates back onto their manifold, and closed contacts back to g_N = 0, γ_N = 0 (and γ_F = 0)
/// where steps have led away from it by more than is left alone.
void HybridRun::correct_drift() {
  const double share = control_.choice() == StepChoice::adaptive ? drift_share * options_.tolerance : 0;
  const double gap_limit = std::max(share, gap_rounding) * scales_.length;
  const double speed_limit = std::max(share, speed_rounding) * scales_.speed;
  bool moved = false, turned = false;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (modes_[i] == ContactMode::open) continue;
    moved = moved || std::abs(system_.gap(i, state_.t, state_.q)) > gap_limit;
    const Eigen::Vector4d& gamma = dynamics_.rows(i).velocity;
    turned = turned || std::abs(gamma[0]) > speed_limit;
    if (modes_[i] == ContactMode::stick) turned = turned || slip_speed(gamma, spin_factor_[i]) > speed_limit;
  }
  system_.restore(state_.q);
  if (moved) instant_.correct_positions(state_, modes_);
  if (moved || turned) instant_.correct_velocities(state_, modes_, report_);
  load();
  if (moved || turned) dynamics_.derivative(state_.t, y_, rate_);
}

}  // namespace contensou
