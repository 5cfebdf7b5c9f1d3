#include "contensou/integrate/event_search.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

namespace contensou {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Relative to the scales of the motion (MotionScales).
constexpr double armed_gap = 1e-13;  ///< an open contact has risen: ten thousand roundings of a height
constexpr double overshoot = 1e-10;  ///< of λ_N and of the friction limit
/// Gaps that small, or that fall to half their size in a step, may have been through zero and back.
constexpr double near_gap = 1e-3;
constexpr int looks_inside = 3;
/// A contact that opened at the step's start is looked at so often: by interpolation alone.
constexpr int looks_at_fresh = 7;

bool quiet(const std::vector<double>& monitors) {
  return std::all_of(monitors.begin(), monitors.end(), [](double x) { return x >= 0; });
}

/// The zero of a function whose signs at the ends differ; `f_left`, `f_right` its values there.
template <class F>
double bracketed_zero(const F& f, double left, double right, double f_left, double f_right) {
  std::uintmax_t evaluations = 60;
  const auto bracket = boost::math::tools::toms748_solve(
      f, left, right, f_left, f_right, boost::math::tools::eps_tolerance<double>(50), evaluations);
  return bracket.second;
}

}  // namespace

EventSearch::EventSearch(ContactDynamics& dynamics, const MotionScales& scales,
                         const std::vector<ContactMode>& modes)
    : dynamics_(dynamics), scales_(scales), modes_(modes), rows_(dynamics.velocities()) {
  const std::size_t count = dynamics.contacts();
  armed_.assign(count, true);
  relaxed_.assign(count, false);
  for (auto* values : {&at_start_, &at_end_, &between_values_, &seen_}) values->assign(2 * count, 0.0);
  for (auto* spins : {&spin_at_start_, &spin_at_end_, &rise_at_start_}) spins->assign(count, 0.0);
  for (Eigen::VectorXd* v : {&between_, &between_rate_}) v->resize(dynamics.size());
}

/// [2i] gap or normal force, [2i+1] what is left of friction.
void EventSearch::monitor(double t, const Eigen::VectorXd& y, std::vector<double>& values) const {
  const double force = scales_.energy / scales_.length;
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    values[2 * i + 1] = 1;
    if (modes_[i] == ContactMode::open) {
      const double gap = dynamics_.system().gap(i, t, y.head(dynamics_.coordinates())) / scales_.length;
      values[2 * i] = armed_[i] ? gap : gap + armed_gap;
      continue;
    }
    const Eigen::Vector4d& lambda = dynamics_.force(i);
    values[2 * i] = lambda[0] / force + overshoot;
    if (modes_[i] == ContactMode::stick && lambda[0] > 0 && !relaxed_[i]) {
      const double gauge = dynamics_.friction(i).gauge(lambda.tail<3>());
      values[2 * i + 1] = 1 - gauge / (dynamics_.system().contacts()[i].mu * lambda[0]) + overshoot;
    }
  }
}

void EventSearch::note_spins(std::vector<double>& spins) const {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const bool spins_here = modes_[i] == ContactMode::slip && dynamics_.friction(i).dimension() > 2;
    spins[i] = spins_here ? dynamics_.rows(i).velocity[3] : 0;
  }
}

void EventSearch::begin(double t, const Eigen::VectorXd& y) {
  monitor(t, y, at_start_);
  note_spins(spin_at_start_);
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (modes_[i] == ContactMode::open) rise_at_start_[i] = normal_velocity(i, t, y);
  }
}

void EventSearch::disarm_touching(double t, const Eigen::VectorXd& q) {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (modes_[i] == ContactMode::open && dynamics_.system().gap(i, t, q) <= armed_gap * scales_.length)
      armed_[i] = false;
  }
}

double EventSearch::normal_velocity(std::size_t contact, double t, const Eigen::VectorXd& y) {
  dynamics_.system().contact_rows(contact, t, y.head(dynamics_.coordinates()),
                                  y.segment(dynamics_.coordinates(), dynamics_.velocities()), rows_);
  return rows_.velocity[0];
}

void EventSearch::accept(double t, const Eigen::VectorXd& y) {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (!fresh(i)) continue;
    armed_[i] = dynamics_.system().gap(i, t, y.head(dynamics_.coordinates())) > armed_gap * scales_.length;
  }
  begin(t, y);
}

bool EventSearch::evaluate_between(OdeStep& stepper, double t, double h, double theta) {
  stepper.interpolate(dynamics_, theta, between_);
  dynamics_.derivative(t + theta * h, between_, between_rate_);
  monitor(t + theta * h, between_, between_values_);
  return quiet(between_values_);
}

/// Whether a monitor that is not negative at either end may have been so between.
bool EventSearch::comes_near() const {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    const double start = at_start_[2 * i];
    const double end = at_end_[2 * i];
    if (modes_[i] != ContactMode::open) {
      if (2 * std::min(start, end) < std::abs(end - start)) return true;
    } else if (armed_[i] && (end < start / 2 || end < near_gap)) {
      return true;
    }
  }
  return false;
}

/// Where in the step the gap of a contact is least that falls at the start and rises at the end, by the cubic
/// with these gaps and velocities. None if that has not half the gaps at the ends: then it is far from zero.
std::optional<double> EventSearch::lowest(std::size_t contact, OdeStep& stepper, double t, double h) {
  if (modes_[contact] != ContactMode::open || !armed_[contact] || !(rise_at_start_[contact] < 0))
    return std::nullopt;
  const double unit = h / scales_.length;
  const double fall = rise_at_start_[contact] * unit;
  const double rise = normal_velocity(contact, t + h, stepper.end()) * unit;
  if (!(rise > 0)) return std::nullopt;
  const double start = at_start_[2 * contact], end = at_end_[2 * contact];
  // Its slope is fall + bθ + aθ², negative at 0, positive at 1: one zero between.
  const double a = 3 * (fall + rise - 2 * (end - start)), b = 2 * (3 * (end - start) - 2 * fall - rise);
  const double root = std::sqrt(std::max(b * b - 4 * a * fall, 0.0));
  const double theta = b > 0 ? -2 * fall / (b + root) : (root - b) / (2 * a);
  const double least = start + theta * (fall + theta * (b / 2 + theta * a / 3));
  return 2 * least < std::min(start, end) ? std::optional(theta) : std::nullopt;
}

/// Where inside the step just tried the gap of a contact is negative that is not so at the end, if looking at
/// the likely places finds one; all monitors are then those of there.
std::optional<double> EventSearch::dip_inside(OdeStep& stepper, double t, double h) {
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (at_end_[2 * i] < 0) continue;
    const std::optional<double> theta = lowest(i, stepper, t, h);
    if (theta && !evaluate_between(stepper, t, h, *theta)) return theta;
  }
  for (std::size_t i = 0; i < modes_.size(); ++i) {
    if (!fresh(i) || at_end_[2 * i] < 0) continue;
    // It may have gone up, down through zero and up again.
    for (int look = 1; look <= looks_at_fresh; ++look) {
      const double theta = static_cast<double>(look) / (looks_at_fresh + 1);
      stepper.interpolate(dynamics_, theta, between_);
      const double gap = dynamics_.system().gap(i, t + theta * h, between_.head(dynamics_.coordinates()));
      if (gap < -armed_gap * scales_.length && !evaluate_between(stepper, t, h, theta)) return theta;
    }
  }
  return std::nullopt;
}

/// Likewise any monitor, where none is negative at the end.
std::optional<double> EventSearch::near_zero_inside(OdeStep& stepper, double t, double h) {
  if (!comes_near()) return std::nullopt;
  for (int look = 1; look <= looks_inside; ++look) {
    const double theta = static_cast<double>(look) / (looks_inside + 1);
    if (!evaluate_between(stepper, t, h, theta)) return theta;
  }
  return std::nullopt;
}

/// The first zero before `last`, where the monitors have these values, of those that are negative there.
std::optional<EventSearch::Found> EventSearch::first_zero(OdeStep& stepper, double t, double h,
                                                          const std::vector<double>& values, double last) {
  std::optional<Found> first;
  for (std::size_t m = 0; m < values.size(); ++m) {
    if (values[m] >= 0) continue;
    const double left = m % 2 == 0 ? risen(stepper, t, h, m / 2, last) : 0;
    const double theta = left == 0 && at_start_[m] < 0 ? 0 : locate(stepper, t, h, m, left, last);
    if (!first || theta < first->theta) first = Found{theta, m / 2, m, m % 2 == 1};
  }
  return first;
}

std::optional<EventSearch::Found> EventSearch::find(OdeStep& stepper, double t, double h) {
  monitor(t + h, stepper.end(), at_end_);
  note_spins(spin_at_end_);
  std::optional<Found> first = first_zero(stepper, t, h, at_end_, 1);
  std::optional<double> inside = dip_inside(stepper, t, h);
  if (!first && !inside) inside = near_zero_inside(stepper, t, h);
  if (inside) {
    seen_ = between_values_;
    const std::optional<Found> other = first_zero(stepper, t, h, seen_, *inside);
    if (!first || (other && other->theta < first->theta)) first = other;
  }
  // What is past zero there was so before, even if it is back at the end of the step.
  for (std::size_t k = 0; k < at_end_.size() && first && first->theta > 0; ++k) {
    evaluate_between(stepper, t, h, first->theta);
    seen_ = between_values_;
    seen_[first->monitor] = 0;
    const std::optional<Found> earlier = first_zero(stepper, t, h, seen_, first->theta);
    if (!earlier || !(earlier->theta < first->theta)) break;
    first = earlier;
  }
  return first;
}

/// Where in the step just tried a contact that opened at its start, or little before, has risen: from there
/// it is watched for closing at zero. 0 where it never has, or was armed before.
double EventSearch::risen(OdeStep& stepper, double t, double h, std::size_t contact, double last) {
  if (!fresh(contact)) return 0;
  constexpr int halvings = 30;
  double theta = last;
  for (int k = 0; k < halvings; ++k) {
    theta /= 2;
    stepper.interpolate(dynamics_, theta, between_);
    const double gap = dynamics_.system().gap(contact, t + theta * h, between_.head(dynamics_.coordinates()));
    if (gap <= armed_gap * scales_.length) continue;
    armed_[contact] = true;
    return theta;
  }
  return 0;
}

double EventSearch::locate(OdeStep& stepper, double t, double h, std::size_t monitor_index, double left,
                           double right) {
  const auto value = [&](double theta) {
    evaluate_between(stepper, t, h, theta);
    return between_values_[monitor_index];
  };
  const double at_left = value(left);
  const double at_right = value(right);
  if (!(at_left > 0)) return left;
  if (!(at_right < 0)) return right;
  return bracketed_zero(value, left, right, at_left, at_right);
}

std::optional<double> EventSearch::land(OdeStep& stepper, double t, const Eigen::VectorXd& y,
                                        const Eigen::VectorXd& rate, double h, const Eigen::VectorXd& scale,
                                        const Found& found) {
  constexpr int attempts = 8;
  constexpr double close_enough = 4 * epsilon;
  constexpr double good_enough = 1e-12;  // where the monitor is rougher than that
  constexpr double before = 1 - 1e-4;    // where the extension gives the first slope
  constexpr double past_the_step = 1.01;
  const double theta_before = before * found.theta;
  evaluate_between(stepper, t, h, theta_before);
  const double value_before = between_values_[found.monitor];
  evaluate_between(stepper, t, h, found.theta);
  const double slope = (between_values_[found.monitor] - value_before) / ((found.theta - theta_before) * h);
  double length = found.theta * h;
  for (int attempt = 0;; ++attempt) {
    if (!std::isfinite(stepper.attempt(dynamics_, t, y, rate, length, scale))) return std::nullopt;
    monitor(t + length, stepper.end(), at_end_);
    note_spins(spin_at_end_);
    const double value = at_end_[found.monitor];
    if (std::abs(value) <= close_enough) return length;
    const double corrected = length - value / slope;
    const bool progress = std::abs(corrected - length) > epsilon * std::abs(t);
    if (attempt == attempts || !(slope < 0) || !progress)
      return std::abs(value) <= good_enough || (slope < 0 && !progress) ? std::optional(length)
                                                                        : std::nullopt;
    if (!(corrected > 0 && corrected <= past_the_step * h)) return std::nullopt;
    length = corrected;
  }
}

std::optional<double> EventSearch::spin_reversal(OdeStep& stepper, double t, double h, std::size_t contact) {
  const double start = spin_at_start_[contact];
  const double end = spin_at_end_[contact];
  if (!(start * end < 0)) return std::nullopt;
  const auto spin = [&](double theta) {
    stepper.interpolate(dynamics_, theta, between_);
    dynamics_.system().contact_rows(contact, t + theta * h, between_.head(dynamics_.coordinates()),
                                    between_.segment(dynamics_.coordinates(), dynamics_.velocities()), rows_);
    return rows_.velocity[3];
  };
  return bracketed_zero(spin, 0.0, 1.0, start, end);
}

}  // namespace contensou
