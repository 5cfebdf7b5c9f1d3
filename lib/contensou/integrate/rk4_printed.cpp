#include "contensou/integrate/rk4_printed.hpp"

#include <array>

#include "contensou/integrate/motion_recorder.hpp"
#include "contensou/integrate/printed.hpp"

namespace contensou {
namespace {

using Eigen::VectorXd;

constexpr std::size_t stages = 4;
constexpr std::array<double, stages> nodes{0, 0.5, 0.5, 1};
using Weights = std::array<double, stages>;
constexpr Weights weights{1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};

/// b_m(θ) of the continuous extension; weights at θ = 1.
Weights weights_at(double theta) {
  const double middle = theta * theta * (1 - 2 * theta / 3);
  return {theta * (1 - theta * (1.5 - 2 * theta / 3)), middle, middle, theta * theta * (2 * theta / 3 - 0.5)};
}

}  // namespace

RunReport run_rk4_printed(const MechanicalSystem& system, State& state, double t_end,
                          const IntegratorOptions& options, const Observer& observer) {
  RunReport report;
  const EqualSteps steps(state.t, t_end, options.step);
  const double dt = steps.step();
  PrintedContacts contacts(system, options, report);
  MotionRecorder recorder(system, state, t_end, options, observer, modes_at_start(system, state), report);

  std::array<VectorXd, stages> u;      // u_m
  std::array<VectorXd, stages> a;      // a_m
  std::array<VectorXd, stages> rates;  // F(q_m)u_m
  rates.fill(VectorXd(system.coordinates()));
  VectorXd q_stage;
  VectorXd q_end;
  VectorXd u_end;
  const auto combine = [&](const Weights& b, VectorXd& q, VectorXd& v) {
    q = state.q + dt * (b[0] * rates[0] + b[1] * rates[1] + b[2] * rates[2] + b[3] * rates[3]);
    v = state.u + dt * (b[0] * a[0] + b[1] * a[1] + b[2] * a[2] + b[3] * a[3]);
  };
  const auto interpolate = [&](double theta, VectorXd& q, VectorXd& v) { combine(weights_at(theta), q, v); };

  for (std::int64_t k = 1; k <= steps.count; ++k) {
    if (k > options.max_steps)
      return end_run(report, RunStatus::step_limit, state.t, "as many steps as allowed");
    contacts.begin_whole_step();
    for (std::size_t m = 0; m < stages; ++m) {
      q_stage = state.q;
      u[m] = state.u;
      if (m > 0) {
        q_stage += nodes[m] * dt * rates[m - 1];
        u[m] += nodes[m] * dt * a[m - 1];
      }
      system.coordinate_rates(q_stage, u[m], rates[m]);
      contacts.step(state.t + nodes[m] * dt, q_stage, u[m], dt / 4);
      a[m] = (contacts.u() - u[m]) / (dt / 4);
      contacts.add(4 * weights[m]);
    }
    combine(weights, q_end, u_end);
    if (!q_end.allFinite() || !u_end.allFinite())
      return end_run(report, RunStatus::not_finite, state.t, "the next state is not finite");
    contacts.end_whole_step(state.u, u_end, recorder.modes());
    recorder.accept(state.t, steps.time(k), contacts.modes(), interpolate);
    state.t = steps.time(k);
    state.q = q_end;
    state.u = u_end;
    system.restore(state.q);
  }
  report.message = contacts.complaint();
  return report;
}

}  // namespace contensou
