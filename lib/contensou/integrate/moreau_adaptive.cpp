#include "contensou/integrate/moreau_adaptive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/integrate/moreau_step.hpp"
#include "contensou/integrate/motion_recorder.hpp"

namespace contensou {
namespace {

constexpr double safety = 0.9;
constexpr double order = 3;  // of the local error
constexpr double proportional = 0.4 / order;
constexpr double integral = 0.7 / order;
constexpr double most_growth = 5;
constexpr double least_growth = 0.2;
constexpr double least_after_rejection = 0.1;
constexpr double after_failure = 0.25;    // of a step whose equations were not solved
constexpr double richardson = 3;          // 2² − 1
constexpr double roundings_of_time = 16;  // shorter steps are none
constexpr double nearly_all = 1.01;       // of what is left to the end: no tiny last step

/// The local error in units of the tolerance.
class ErrorNorm {
 public:
  ErrorNorm(const MechanicalSystem& system, double tolerance)
      : system_(system),
        tolerance_(tolerance),
        scale_(system.coordinates()),
        mass_(system.velocities(), system.velocities()),
        difference_(system.velocities()),
        momentum_(system.velocities()) {
    system.coordinate_scales(scale_);
  }

  void see(const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
    fastest_ = std::max(fastest_, 2 * system_.kinetic_energy(q, u));
  }

  double operator()(const ContactState& halves, const ContactState& whole) {
    see(halves.q, halves.u);
    const double of_q = (halves.q - whole.q).cwiseQuotient(scale_).lpNorm<Eigen::Infinity>();
    difference_ = halves.u - whole.u;
    system_.mass_matrix(halves.q, mass_);
    momentum_.noalias() = mass_ * difference_;
    const double square = difference_.dot(momentum_);
    const double of_u = square > 0 ? std::sqrt(square / fastest_) : 0;
    const double error = std::max(of_q, of_u) / richardson / tolerance_;
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
  }

  /// Of the energy that an impact took: whole and halves that both end at rest agree in the state, however
  /// different the times are at which they landed.
  double of_impacts(const MoreauStep& first, const MoreauStep& second, const MoreauStep& whole) const {
    const auto taken = [](const MoreauStep& step) {
      double energy = 0;
      for (const Dissipation& d : step.accounts().dissipated()) energy += d.impact;
      return energy;
    };
    const double difference = std::abs(taken(first) + taken(second) - taken(whole));
    return difference > 0 ? difference / (fastest_ / 2) / richardson / tolerance_ : 0;
  }

 private:
  const MechanicalSystem& system_;
  double tolerance_;
  double fastest_ = 0;  ///< uᵀMu
  Eigen::VectorXd scale_;
  Eigen::MatrixXd mass_;
  Eigen::VectorXd difference_;
  Eigen::VectorXd momentum_;
};

class StepSize {
 public:
  /// Factor on Δt after a step with this error was accepted.
  double accepted(double error, bool smooth) {
    const double e = std::max(error, smallest);
    const double factor = safety * std::pow(e, -integral) * std::pow(before_, proportional);
    before_ = smooth ? e : 1;  // what a change of mode did says nothing of what follows
    return std::clamp(factor, least_growth, most_growth);
  }
  double rejected(double error) {
    before_ = 1;
    return std::clamp(safety * std::pow(error, -1 / order), least_after_rejection, safety);
  }

 private:
  static constexpr double smallest = 1e-6;
  double before_ = 1;
};

}  // namespace

RunReport run_moreau_adaptive(const MechanicalSystem& system, State& state, double t_end,
                              const IntegratorOptions& options, const Observer& observer) {
  constexpr auto kind = MoreauStep::Kind::second_order;
  using Outcome = MoreauStep::Outcome;
  RunReport report;
  ContactState now{state.q, state.u, modes_at_start(system, state)};
  MoreauStep whole(system, options, kind, report);
  MoreauStep first(system, options, kind, report);
  MoreauStep second(system, options, kind, report);
  MotionRecorder recorder(system, state, t_end, options, observer, now.modes, report);
  ErrorNorm norm(system, options.tolerance);
  norm.see(state.q, state.u);
  StepSize control;
  const double floor_in_steps = std::min(1.0, std::cbrt(options.tolerance));
  double longest = 0;
  double dt = options.step;

  const auto keep = [&](double from, double to, const MoreauStep& half) {
    half.accounts().add_to(report);
    recorder.accept(
        from, to, half.end().modes,
        [&half](double theta, Eigen::VectorXd& q, Eigen::VectorXd& u) { half.interpolate(theta, q, u); },
        half.time_of_events(from, to), half.bounced());
  };

  while (state.t < t_end) {
    if (report.steps >= options.max_steps)
      return end_run(report, RunStatus::step_limit, state.t, "as many steps as allowed");
    const double left = t_end - state.t;
    const bool last = left <= nearly_all * dt;
    const double tried = last ? left : dt;
    const double middle = state.t + tried / 2;
    const double end = last ? t_end : state.t + tried;
    const double rounding =
        std::numeric_limits<double>::epsilon() * std::max(std::abs(state.t), std::abs(t_end));
    if (!last && tried < roundings_of_time * rounding)
      return end_run(report, RunStatus::step_too_small, state.t, "the step no longer changes the time");

    Outcome outcome = whole.attempt(state.t, now, tried);
    if (outcome == Outcome::solved) outcome = first.attempt(state.t, now, tried / 2);
    if (outcome == Outcome::solved) outcome = second.attempt(middle, first.end(), tried / 2);
    if (outcome != Outcome::solved) {
      ++report.rejected;
      dt = after_failure * tried;
      if (dt < roundings_of_time * rounding) return end_run(report, outcome, state.t);
      continue;
    }
    const bool smooth = whole.smooth() && first.smooth() && second.smooth();
    double error = norm(second.end(), whole.end());
    if (!smooth) error = std::max(error, norm.of_impacts(first, second, whole));
    const bool at_floor = !smooth && tried <= floor_in_steps * longest;
    // Whole and halves may agree in what neither sees.
    const bool blind = whole.suppressed() || first.suppressed() || second.suppressed();
    if ((!(error <= 1) || blind) && !at_floor) {
      ++report.rejected;
      dt = (blind ? least_after_rejection : control.rejected(error)) * tried;
      if (!smooth) dt = std::max(dt, floor_in_steps * longest);
      continue;
    }
    keep(state.t, middle, first);
    keep(middle, end, second);
    now = second.end();
    state.t = end;
    state.q = now.q;
    state.u = now.u;
    longest = std::max(longest, tried);
    dt = at_floor && error > 1 ? tried : control.accepted(error, smooth) * tried;
  }
  return report;
}

}  // namespace contensou
