#include "contensou/integrate/moreau_printed.hpp"

#include "contensou/integrate/motion_recorder.hpp"
#include "contensou/integrate/printed.hpp"

namespace contensou {

RunReport run_moreau_printed(const MechanicalSystem& system, State& state, double t_end,
                             const IntegratorOptions& options, const Observer& observer) {
  RunReport report;
  const EqualSteps steps(state.t, t_end, options.step);
  PrintedContacts contacts(system, options, report);
  MotionRecorder recorder(system, state, t_end, options, observer, modes_at_start(system, state), report);
  const auto interpolate = [&](double theta, Eigen::VectorXd& q, Eigen::VectorXd& u) {
    u = state.u + theta * (contacts.u() - state.u);
    q = theta < 0.5 ? state.q + 2 * theta * (contacts.q_mid() - state.q)
                    : contacts.q_mid() + (2 * theta - 1) * (contacts.q() - contacts.q_mid());
  };

  for (std::int64_t k = 1; k <= steps.count; ++k) {
    if (k > options.max_steps)
      return end_run(report, RunStatus::step_limit, state.t, "as many steps as allowed");
    contacts.step(state.t, state.q, state.u, steps.step());
    if (!contacts.q().allFinite() || !contacts.u().allFinite())
      return end_run(report, RunStatus::not_finite, state.t, "the next state is not finite");
    contacts.begin_whole_step();
    contacts.add(1);
    contacts.end_whole_step(state.u, contacts.u(), recorder.modes());
    recorder.accept(state.t, steps.time(k), contacts.modes(), interpolate);
    state.t = steps.time(k);
    state.q = contacts.q();
    state.u = contacts.u();
    system.restore(state.q);
  }
  report.message = contacts.complaint();
  return report;
}

}  // namespace contensou
