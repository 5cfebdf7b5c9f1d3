#include "contensou/integrate/moreau.hpp"

#include "contensou/integrate/moreau_step.hpp"
#include "contensou/integrate/motion_recorder.hpp"

namespace contensou {
namespace {

RunReport run(MoreauStep::Kind kind, const MechanicalSystem& system, State& state, double t_end,
              const IntegratorOptions& options, const Observer& observer) {
  RunReport report;
  const EqualSteps steps(state.t, t_end, options.step);
  ContactState now{state.q, state.u, modes_at_start(system, state)};
  MoreauStep step(system, options, kind, report);
  MotionRecorder recorder(system, state, t_end, options, observer, now.modes, report);
  const auto interpolate = [&](double theta, Eigen::VectorXd& q, Eigen::VectorXd& u) {
    step.interpolate(theta, q, u);
  };

  for (std::int64_t k = 1; k <= steps.count; ++k) {
    if (k > options.max_steps)
      return end_run(report, RunStatus::step_limit, state.t, "as many steps as allowed");
    const MoreauStep::Outcome outcome = step.attempt(state.t, now, steps.step());
    if (outcome != MoreauStep::Outcome::solved) return end_run(report, outcome, state.t);
    step.accounts().add_to(report);
    recorder.accept(state.t, steps.time(k), step.end().modes, interpolate,
                    step.time_of_events(state.t, steps.time(k)), step.bounced());
    now = step.end();
    state.t = steps.time(k);
    state.q = now.q;
    state.u = now.u;
  }
  return report;
}

}  // namespace

RunReport run_moreau(const MechanicalSystem& system, State& state, double t_end,
                     const IntegratorOptions& options, const Observer& observer) {
  return run(MoreauStep::Kind::second_order, system, state, t_end, options, observer);
}

RunReport run_moreau_implicit(const MechanicalSystem& system, State& state, double t_end,
                              const IntegratorOptions& options, const Observer& observer) {
  return run(MoreauStep::Kind::implicit, system, state, t_end, options, observer);
}

}  // namespace contensou
