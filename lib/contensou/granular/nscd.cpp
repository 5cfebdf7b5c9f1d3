#include "contensou/granular/nscd.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

#include "contensou/granular/nscd_step.hpp"
#include "contensou/granular/rule_check.hpp"
#include "contensou/integrate/motion_recorder.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

[[noreturn]] void reject(const char* what, double value, const char* expected) {
  throw std::invalid_argument(std::string("integrator: ") + what + " " + to_text(value) + ", expected " +
                              expected);
}

void require_valid(const BodyLayout& layout, const State& state, double t_end,
                   const IntegratorOptions& options, int threads) {
  const auto positive = [](const char* what, double value) {
    if (!(value > 0 && std::isfinite(value))) reject(what, value, "a number > 0");
  };
  positive("step", options.step);
  positive("solver_tolerance", options.solver_tolerance);
  if (!(options.output_interval > 0)) reject("output_interval", options.output_interval, "a number > 0");
  if (options.fidelity && !(*options.fidelity >= 0 && *options.fidelity < 1))
    reject("fidelity", *options.fidelity, "a number >= 0 and < 1");
  if (threads < 1) reject("threads", threads, "a number >= 1");
  if (state.q.size() != layout.coordinates() || state.u.size() != layout.velocities())
    throw std::invalid_argument("integrator: the state is of another size than the bodies");
  if (!state.q.allFinite() || !state.u.allFinite() || !std::isfinite(state.t))
    throw std::invalid_argument("integrator: the state has a number that is not finite");
  if (!(t_end >= state.t && std::isfinite(t_end)))
    reject("t_end", t_end, ("a number >= " + to_text(state.t)).c_str());
}

/// Quaternions to unit length.
void restore(const BodyLayout& layout, Eigen::VectorXd& q) {
  for (std::size_t i = 0; i < layout.bodies(); ++i) {
    if (layout.data().bodies[i].rotation == Rotation::free)
      q.segment<4>(layout.first_coordinate(i) + 3).normalize();
  }
}

/// How many inclusions were not solved, and how bad; empty if none.
std::string unsolved_message(const RunReport& report, const NscdCounts& met, double tolerance) {
  if (met.unsolved == 0) return {};
  char worst[32];
  std::snprintf(worst, sizeof worst, "%.2g", report.worst_residual);
  return std::to_string(met.unsolved) + " of " + std::to_string(report.steps) +
         " steps: contacts not solved to " + to_text(tolerance) + ", worst residual " + worst;
}

/// Shows the motion where it is to be shown: linear within a step.
class Shower {
 public:
  Shower(const BodyLayout& layout, const State& state, double t_end, double interval,
         const Observer& observer)
      : layout_(layout), observer_(observer), clock_(state.t, t_end, interval) {
    if (observer_) show(state, state);
  }

  /// Before a step: what show() needs of it.
  void keep(const State& state) {
    if (observer_) last_ = state;
  }
  void show(const State& state) {
    if (observer_) show(last_, state);
  }

 private:
  void show(const State& from, const State& to) {
    for (; clock_.next() <= to.t; clock_.advance()) {
      const double t = clock_.next();
      const double part = to.t > from.t ? (t - from.t) / (to.t - from.t) : 1;
      q_ = from.q + part * (to.q - from.q);
      u_ = from.u + part * (to.u - from.u);
      restore(layout_, q_);
      observer_({t, q_, u_, no_modes_});
    }
  }

  const BodyLayout& layout_;
  const Observer& observer_;
  SampleClock clock_;
  State last_{};
  Eigen::VectorXd q_, u_;
  std::vector<ContactMode> no_modes_;
};

}  // namespace

RunReport run_nscd(const BodiesData& data, State& state, double t_end, const IntegratorOptions& options,
                   int threads, const Observer& observer, NscdCounts* counts) {
  contensou::require_valid(data);
  require_valid_rules(data);
  const BodyLayout layout(data);
  require_valid(layout, state, t_end, options, threads);
  RunReport report;
  NscdCounts unwanted;
  NscdCounts& met = counts ? *counts : unwanted;
  met = {};
  const EqualSteps steps(state.t, t_end, options.step);
  WorkerTeam team(threads);
  NscdStep step(layout, options, team, report, met);
  step.require_apart(state, options.step);
  met = {};
  Shower shower(layout, state, t_end, options.output_interval, observer);
  for (std::int64_t k = 1; k <= steps.count; ++k) {
    if (k > options.max_steps)
      return end_run(report, RunStatus::step_limit, state.t, "as many steps as allowed");
    shower.keep(state);
    step.advance(state, steps.step());
    if (!state.q.allFinite() || !state.u.allFinite())
      return end_run(report, RunStatus::not_finite, state.t, "a number that is not finite");
    state.t = steps.time(k);
    ++report.steps;
    shower.show(state);
  }
  report.message = unsolved_message(report, met, options.solver_tolerance);
  return report;
}

}  // namespace contensou
