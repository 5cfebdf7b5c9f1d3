#include "contensou/integrate/hybrid_run.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Relative to the scales of the motion (MotionScales).
constexpr double closed_gap = 1e-12;      ///< gaps of this size are closed at the start
constexpr double armed_gap = 1e-13;       ///< an open contact has risen: ten thousand roundings of a height
constexpr double approach_speed = 1e-11;  ///< beside the rounding of γ_N, 1e-16, and below all that matters
constexpr double slip_at_rest = 1e-11;    ///< likewise, and ...
/// ... times the tolerance: slip so slow that steps through zero pass the error control, which then no longer
/// sees that friction jumps there.
constexpr double slip_unresolved = 50;
constexpr double overshoot = 1e-10;       ///< of λ_N and of the friction limit: events are just past zero
/// Bounces shorter than this are summed: five times as long as one of the height `armed_gap` ...
constexpr double short_bounce = 5e-6;
/// ... or, times √tolerance, as one as high as errors are.
constexpr double short_bounce_root = 1;
/// Seven impacts within this many of them are no longer resolved, whatever they look like.
constexpr double unresolved_impacts = 24;
/// A contact that leaves an impact for a bounce shorter than this part of that stays closed.
constexpr double no_bounce = 0.1;

/// h·rate at which the explicit methods become unstable is 2.8 (order 4) to 6 (order 8).
constexpr double stable = 2.0;
constexpr double limited_by_stability = 3.5;
/// An implicit step costs some four explicit ones.
constexpr double worth_implicit = 12;
constexpr int implicit_trial = 8;  ///< steps in which the implicit method may find its step size
constexpr int longest_patience = 512;
constexpr double share_of_time_to_rest = 0.7;
constexpr int most_stalled = 200;
constexpr int landing_attempts = 8;

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
      choice_(choice),
      dynamics_(system),
      instant_(system, options.solver_tolerance),
      scales_(motion_scales(system, state)),
      clock_(state.t, t_end, options.output_interval),
      t_start_(state.t) {
  const std::size_t count = system.contacts().size();
  modes_.assign(count, ContactMode::open);
  armed_.assign(count, true);
  impacts_.resize(count);
  for (auto* times : {&opened_, &flight_}) times->assign(count, -infinite);
  for (const SystemContact& contact : system.contacts())
    spin_factor_.push_back(contact.mu > 0 ? spin_factor(contact, scales_.length) : 0);
  for (auto* values : {&at_start_, &at_end_, &at_theta_}) values->assign(2 * count, 0.0);
  for (Eigen::VectorXd* v : {&y_, &rate_, &scale_, &between_, &between_rate_})
    v->setZero(dynamics_.size());
  report_.dissipated.assign(count, {});
  const double unresolved = choice_ == StepChoice::adaptive ? slip_unresolved * options_.tolerance : 0;
  const double error = choice_ == StepChoice::adaptive ? std::sqrt(options_.tolerance) : 0;
  shortest_bounce_ = std::max(short_bounce, short_bounce_root * error) * scales_.time;
  const double bounce_speed = no_bounce * shortest_bounce_ * scales_.length / (scales_.time * scales_.time);
  tolerances_ = {.approach = approach_speed * scales_.speed,
                 .bounce = bounce_speed / 2,
                 .slip = std::max(slip_at_rest, unresolved) * scales_.speed,
                 .length = scales_.length};
}

RunReport HybridRun::run() {
  if (start()) {
    while (state_.t < t_end_ && report_.status == RunStatus::finished) {
      if (report_.steps + report_.rejected >= options_.max_steps) {
        report_.status = RunStatus::step_limit;
        report_.message = "no more than " + std::to_string(options_.max_steps) + " steps allowed, at t = " +
                          to_text(state_.t) + " s";
        break;
      }
      if (!advance()) break;
    }
  }
  unload(y_, state_.t);
  if (report_.status == RunStatus::finished) {
    // Whoever goes on from here starts with closed contacts closed.
    instant_.correct_positions(state_, modes_);
    instant_.correct_velocities(state_, modes_, report_);
    load();
  }
  if (report_.status == RunStatus::finished) show_until(t_end_, nullptr, 0);
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const Eigen::Index at = dynamics_.coupled() + 2 * static_cast<Eigen::Index>(i);
    report_.dissipated[i].sliding = y_[at];
    report_.dissipated[i].drilling = y_[at + 1];
  }
  report_.evaluations = dynamics_.evaluations();
  return report_;
}

/// Which contacts are closed, and a first step.
bool HybridRun::start() {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (system_.gap(i, state_.t, state_.q) <= closed_gap * scales_.length) modes_[i] = ContactMode::slip;
  }
  modes_before_.assign(modes_.size(), ContactMode::open);
  set_error_scales();
  if (!settle("start", state_.t)) return false;
  report_.events.clear();  // how it starts is no event
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (instant_.struck(i)) record_change(state_.t, i, ContactMode::open, modes_[i], report_.events);
  }
  if (choice_ == StepChoice::adaptive) {
    // A step in which coordinates and velocities change by a hundredth of their scales.
    const double change =
        (rate_.head(dynamics_.coupled()).array() / scale_.head(dynamics_.coupled()).array()).abs().maxCoeff() *
        options_.tolerance;
    h_ = 0.01 * (change > 0 ? std::min(1 / change, scales_.time) : scales_.time);
  }
  show_until(state_.t, nullptr, 0);
  return true;
}

void HybridRun::load() {
  y_.head(dynamics_.coordinates()) = state_.q;
  y_.segment(dynamics_.coordinates(), dynamics_.velocities()) = state_.u;
}

void HybridRun::set_error_scales() {
  const auto n = dynamics_.coordinates();
  const auto f = dynamics_.velocities();
  scale_.head(n) = options_.tolerance * scales_.coordinate;
  scale_.segment(n, f) = options_.tolerance * scales_.velocity;
  scale_.tail(scale_.size() - n - f).setConstant(options_.tolerance * scales_.energy);
}

void HybridRun::unload(const Eigen::VectorXd& y, double t) {
  state_.t = t;
  state_.q = y.head(dynamics_.coordinates());
  state_.u = y.segment(dynamics_.coordinates(), dynamics_.velocities());
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
    if (fall < 0) {
      time_to_rest_ = std::min(time_to_rest_, -square / fall);
      slowest_slip_ = std::min(slowest_slip_, std::sqrt(square));
    }
  }
}

/// Solves the instant, records what changed as of time t, and makes everything ready for the next step.
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
    const bool bounced =
        instant_.struck(i) && modes_before_[i] == ContactMode::open && modes_[i] == ContactMode::open;
    if (bounced) {
      report_.events.push_back({t, EventKind::close, i});
      report_.events.push_back({t, EventKind::open, i});
    }
    record_change(t, i, modes_before_[i], modes_[i], report_.events);
    if (modes_[i] == ContactMode::open && (modes_before_[i] != ContactMode::open || instant_.struck(i)))
      armed_[i] = false;
  }
  modes_before_ = modes_;
  dynamics_.set_modes(modes_);
  load();
  dynamics_.derivative(state_.t, y_, rate_);
  read_rates();
  monitor(state_.t, y_, at_start_);
  return true;
}

/// Ends series of impacts that are no longer resolved: the contacts whose series have the same limit close.
bool HybridRun::close_accumulated() {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (instant_.struck(i)) impacts_[i].add(state_.t);
    flight_[i] = state_.t - opened_[i];
    if (modes_[i] == ContactMode::open && !armed_[i]) opened_[i] = state_.t;
  }
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (!instant_.struck(i) || flight_[i] > shortest_bounce_) continue;
    const std::optional<double> limit = impacts_[i].limit(unresolved_impacts * shortest_bounce_);
    if (!limit) continue;
    std::vector<std::size_t> together;
    for (std::size_t j = 0; j < modes_.size(); ++j) {
      const std::optional<double> other = impacts_[j].limit(unresolved_impacts * shortest_bounce_);
      if (!other || std::abs(*other - *limit) > 2 * (*limit - state_.t) + shortest_bounce_) continue;
      together.push_back(j);
      if (modes_[j] == ContactMode::open) modes_[j] = ContactMode::slip;
    }
    instant_.correct_velocities(state_, modes_, report_);
    if (!settle("accumulation of impacts", *limit)) return false;
    for (const std::size_t j : together) {
      report_.events.push_back({*limit, EventKind::accumulation, j});
      impacts_[j].clear();
    }
    return true;
  }
  return true;
}

OdeStep& HybridRun::choose_stepper(double h) {
  if (choice_ == StepChoice::fixed) {
    use_implicit_ = h * relaxation_ > stable;
  } else if (!use_implicit_) {
    limited_ = std::max(0, limited_ + (h * relaxation_ > limited_by_stability ? 2 : -1));
    if (limited_ >= 2 * patience_) {
      use_implicit_ = true;
      on_trial_ = implicit_trial;
    }
  } else if (on_trial_ > 0) {
    --on_trial_;
  } else if (h * relaxation_ < worth_implicit) {
    use_implicit_ = false;
    limited_ = 0;
    patience_ = std::min(2 * patience_, longest_patience);
  }
  if (use_implicit_) return implicit_;
  return explicit_;
}

double HybridRun::next_grid_time() const {
  return t_start_ + static_cast<double>(grid_ + 1) * options_.step;
}

double HybridRun::longest_step() const {
  double h = t_end_ - state_.t;
  h = std::min(h, choice_ == StepChoice::fixed ? next_grid_time() - state_.t : h_);
  if (choice_ == StepChoice::fixed && rejected_) h = std::min(h, h_);
  return std::min(h, share_of_time_to_rest * time_to_rest_);
}

void HybridRun::adapt(double error, bool accepted, const OdeStep& stepper) {
  const double safety = 0.9;
  double factor = 0.25;
  if (std::isfinite(error)) {
    const double largest = accepted && !rejected_ ? 6.0 : 1.0;
    factor = error > 0 ? std::clamp(safety * std::pow(error, -1.0 / stepper.error_order()), 0.2, largest)
                       : largest;
  }
  h_ *= factor;
}

/// Values that are not negative as long as nothing happens: [2i] gap or normal force, [2i+1] what is left of
/// friction; both relative. The last evaluation of dynamics_ was at (t, y).
void HybridRun::monitor(double t, const Eigen::VectorXd& y, std::vector<double>& values) const {
  const double force = scales_.energy / scales_.length;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    values[2 * i + 1] = 1;
    if (modes_[i] == ContactMode::open) {
      const double gap = system_.gap(i, t, y.head(dynamics_.coordinates())) / scales_.length;
      values[2 * i] = armed_[i] ? gap : gap + armed_gap;
      continue;
    }
    const Eigen::Vector4d& lambda = dynamics_.force(i);
    values[2 * i] = lambda[0] / force + overshoot;
    if (modes_[i] == ContactMode::stick && lambda[0] > 0) {
      const double gauge = dynamics_.friction(i).gauge(lambda.tail<3>());
      values[2 * i + 1] = 1 - gauge / (system_.contacts()[i].mu * lambda[0]) + overshoot;
    }
  }
}

bool HybridRun::evaluate_between(OdeStep& stepper, double h, double theta, std::vector<double>& values) {
  stepper.interpolate(dynamics_, theta, between_);
  const double t = state_.t + theta * h;
  dynamics_.derivative(t, between_, between_rate_);
  monitor(t, between_, values);
  return std::all_of(values.begin(), values.end(), [](double x) { return x >= 0; });
}

/// The first event of the step just tried, whose end's monitors are at_end_.
std::optional<HybridRun::Found> HybridRun::find_event(OdeStep& stepper, double h) {
  double last = 1;  // looked at up to here
  bool quiet = std::all_of(at_end_.begin(), at_end_.end(), [](double x) { return x >= 0; });
  if (quiet) {
    // A monitor may dip below zero and come back: looked for where it comes near.
    bool near = false;
    for (std::size_t m = 0; m < at_end_.size(); m += 2) {
      if (modes_[m / 2] != ContactMode::open) {
        near = near || 2 * std::min(at_start_[m], at_end_[m]) < std::abs(at_end_[m] - at_start_[m]);
      } else if (armed_[m / 2]) {
        near = near || (at_end_[m] < at_start_[m] / 2) || (at_end_[m] < 1e-3);
      }
    }
    for (int k = 1; near && quiet && k < 4; ++k) {
      last = k / 4.0;
      quiet = evaluate_between(stepper, h, last, at_theta_);
    }
    if (quiet) return std::nullopt;
    at_end_ = at_theta_;
  }
  std::optional<Found> first;
  for (std::size_t m = 0; m < at_end_.size(); ++m) {
    if (at_end_[m] >= 0) continue;
    const double left = m % 2 == 0 ? risen(stepper, m / 2, last, h) : 0;
    const double theta = left == 0 && at_start_[m] < 0 ? 0 : locate(stepper, h, m, left, last);
    if (!first || theta < first->theta) first = Found{theta, m};
  }
  return first;
}

/// Where in the step just tried a contact that opened at its start, or little before, has risen: from there it
/// is watched for closing at zero. 0 where it never has, or was armed before.
double HybridRun::risen(OdeStep& stepper, std::size_t contact, double last, double h) {
  if (modes_[contact] != ContactMode::open || armed_[contact]) return 0;
  constexpr int halvings = 30;
  double theta = last;
  for (int k = 0; k < halvings; ++k) {
    theta /= 2;
    stepper.interpolate(dynamics_, theta, between_);
    const double gap = system_.gap(contact, state_.t + theta * h, between_.head(dynamics_.coordinates()));
    if (gap <= armed_gap * scales_.length) continue;
    armed_[contact] = true;
    return theta;
  }
  return 0;
}

double HybridRun::locate(OdeStep& stepper, double h, std::size_t monitor_index, double left, double right) {
  const auto value = [&](double theta) {
    evaluate_between(stepper, h, theta, at_theta_);
    return at_theta_[monitor_index];
  };
  const double at_left = value(left);
  const double at_right = value(right);
  if (!(at_left > 0)) return left;
  if (!(at_right < 0)) return right;
  std::uintmax_t evaluations = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      value, left, right, at_left, at_right, boost::math::tools::eps_tolerance<double>(50), evaluations);
  return bracket.second;
}

/// Takes the step that ends at the event: first of the length found, then corrected by the secant rule until
/// its own end is at zero. False where it does not get there: then the step was too long for its extension.
bool HybridRun::land(OdeStep& stepper, double h, const Found& found) {
  constexpr double close_enough = 4 * epsilon;
  constexpr double good_enough = 1e-12;  // where the monitor is rougher than that
  constexpr double before = 1 - 1e-4;    // where the extension gives the first slope
  const double theta_before = before * found.theta;
  evaluate_between(stepper, h, theta_before, at_theta_);
  const double value_before = at_theta_[found.monitor];
  evaluate_between(stepper, h, found.theta, at_theta_);
  double slope = (at_theta_[found.monitor] - value_before) / ((found.theta - theta_before) * h);
  double length = found.theta * h;
  for (int attempt = 0;; ++attempt) {
    const double error = stepper.attempt(dynamics_, state_.t, y_, rate_, length, scale_);
    if (!std::isfinite(error)) return false;
    monitor(state_.t + length, stepper.end(), at_end_);
    const double value = at_end_[found.monitor];
    if (std::abs(value) <= close_enough) break;
    if (attempt == landing_attempts || !(slope < 0)) {
      if (std::abs(value) > good_enough) return false;
      break;
    }
    const double corrected = length - value / slope;
    if (!(corrected > 0 && corrected <= 1.01 * h)) return false;
    const double moved = corrected - length;
    // A secant through values that rounding makes up has no slope: the first one will do.
    if (attempt > 0 && std::abs(moved) <= epsilon * std::abs(state_.t)) break;
    length = corrected;
  }
  show_until(state_.t + length, &stepper, length);
  y_ = stepper.end();
  ++report_.steps;
  unload(y_, state_.t + length);
  return true;
}

/// Calls the observer for all sample times up to t; `stepper` holds the step of length h from state_.t.
void HybridRun::show_until(double t, OdeStep* stepper, double h) {
  if (!observer_) return;
  while (clock_.next() <= t) {
    const double at = clock_.next();
    if (stepper != nullptr && at < state_.t + h && at > state_.t) {
      stepper->interpolate(dynamics_, (at - state_.t) / h, between_);
    } else {
      between_ = stepper != nullptr && at > state_.t ? stepper->end() : y_;
    }
    Eigen::VectorXd q = between_.head(dynamics_.coordinates());
    const Eigen::VectorXd u = between_.segment(dynamics_.coordinates(), dynamics_.velocities());
    system_.restore(q);
    observer_({at, q, u, modes_});
    clock_.advance();
  }
}

/// Open contacts that have risen are watched for closing at zero; before, a rounding below.
void HybridRun::arm() {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (modes_[i] == ContactMode::open && !armed_[i])
      armed_[i] = system_.gap(i, state_.t, state_.q) > armed_gap * scales_.length;
  }
}

/// Brings closed contacts back to g_N = 0, γ_N = 0 (and γ_F = 0) where steps have led away from it by more
/// than a tenth of what the error control allows, or than rounding.
void HybridRun::correct_drift() {
  const double share = choice_ == StepChoice::adaptive ? 0.1 * options_.tolerance : 0;
  const double gap_limit = std::max(share, 8 * epsilon) * scales_.length;
  const double speed_limit = std::max(share, 64 * epsilon) * scales_.speed;
  bool moved = false, turned = false;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (modes_[i] == ContactMode::open) continue;
    moved = moved || std::abs(system_.gap(i, state_.t, state_.q)) > gap_limit;
    const Eigen::Vector4d& gamma = dynamics_.rows(i).velocity;
    turned = turned || std::abs(gamma[0]) > speed_limit;
    if (modes_[i] == ContactMode::stick) turned = turned || slip_speed(gamma, spin_factor_[i]) > speed_limit;
  }
  const Eigen::Index n = dynamics_.coordinates();
  system_.restore(state_.q);
  if (moved) instant_.correct_positions(state_, modes_);
  if (moved || turned) instant_.correct_velocities(state_, modes_, report_);
  const bool changed = moved || turned || state_.q != y_.head(n);
  if (!changed) return;
  y_.head(n) = state_.q;
  y_.segment(n, dynamics_.velocities()) = state_.u;
  if (moved || turned) dynamics_.derivative(state_.t, y_, rate_);
}

/// One step, or one event.
bool HybridRun::advance() {
  const double h = longest_step();
  const double smallest = 4 * epsilon * std::max(std::abs(state_.t), scales_.time);
  const bool ends_here = t_end_ - state_.t <= smallest;
  if (ends_here) {
    state_.t = t_end_;
    return true;
  }
  if (!(h > smallest)) {
    if (choice_ == StepChoice::fixed && next_grid_time() - state_.t <= smallest) {
      ++grid_;
      return true;
    }
    report_.status = RunStatus::step_too_small;
    report_.message = "steps of " + to_text(h) + " s at t = " + to_text(state_.t) + " s";
    return false;
  }
  OdeStep& stepper = choose_stepper(h);
  const double error = stepper.attempt(dynamics_, state_.t, y_, rate_, h, scale_);
  if (!(error <= 1) && (choice_ == StepChoice::adaptive || !std::isfinite(error))) {
    ++report_.rejected;
    h_ = h;
    adapt(error, false, stepper);
    rejected_ = true;
    return true;
  }
  monitor(state_.t + h, stepper.end(), at_end_);
  const std::vector<double> end_monitors = at_end_;
  if (const std::optional<Found> found = find_event(stepper, h)) {
    if (found->theta * h > smallest) {
      stalled_ = 0;
      if (!land(stepper, h, *found)) {
        h_ = h / 4;
        rejected_ = true;
        ++report_.rejected;
        return true;
      }
    } else if (++stalled_ > most_stalled) {
      report_.status = RunStatus::solver_failed;
      report_.message = "contacts change their state without end at t = " + to_text(state_.t) + " s";
      return false;
    }
    system_.restore(state_.q);
    const std::size_t contact = found->monitor / 2;
    if (modes_[contact] == ContactMode::open) modes_[contact] = ContactMode::slip;  // closed, for settle
    if (!settle("event", state_.t)) return false;
    return close_accumulated();
  }

  stalled_ = 0;
  show_until(state_.t + h, &stepper, h);
  y_ = stepper.end();
  rate_ = stepper.end_rate();
  const double reached = choice_ == StepChoice::fixed && h == next_grid_time() - state_.t ? next_grid_time()
                                                                                          : state_.t + h;
  unload(y_, reached);
  ++report_.steps;
  if (choice_ == StepChoice::adaptive) {
    if (h >= h_ || error > 0.1) {
      h_ = h;
      adapt(error, true, stepper);
    }
  } else {
    h_ = 2 * h;
    if (next_grid_time() - state_.t <= smallest) ++grid_;
  }
  rejected_ = false;
  at_start_ = end_monitors;
  if (!y_.allFinite()) {
    report_.status = RunStatus::not_finite;
    report_.message = "the state is no longer finite at t = " + to_text(state_.t) + " s";
    return false;
  }
  if (stepper.end_rate().size() > 0) dynamics_.derivative(state_.t, y_, rate_);
  correct_drift();
  arm();
  read_rates();
  if (slowest_slip_ <= tolerances_.slip) return settle("slip that came to rest", state_.t);
  return true;
}

}  // namespace contensou
