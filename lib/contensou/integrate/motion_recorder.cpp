#include "contensou/integrate/motion_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "contensou/integrate/schemes.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

constexpr double rounding_of_count = 1e-12;
constexpr double most_steps = 0x1p53;  // beyond, t + Δt is t

}  // namespace

EqualSteps::EqualSteps(double from, double to, double step) : start(from), end(to), count(0) {
  const double steps = std::ceil((to - from) / step * (1 - rounding_of_count));
  if (steps > most_steps)
    throw std::invalid_argument("integrator: step " + to_text(step) + ", too small for times up to " +
                                to_text(to));
  count = to > from ? std::max<std::int64_t>(1, static_cast<std::int64_t>(steps)) : 0;
}

std::vector<ContactMode> modes_at_start(const MechanicalSystem& system, const State& state) {
  std::vector<ContactMode> modes(system.contacts().size(), ContactMode::open);
  ContactRows contact(system.velocities());
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (system.gap(i, state.t, state.q) > closed_at_start * system.length_scale()) continue;
    system.contact_rows(i, state.t, state.q, state.u, contact);
    // What rounding makes of γ_N = Wᵀu + w̃.
    const double rounding = 1e-14 * (contact.directions.col(0).cwiseAbs().dot(state.u.cwiseAbs()) +
                                     std::abs(contact.velocity[0]));
    if (std::abs(contact.velocity[0]) > rounding) continue;
    const int friction = rows(system.contacts()[i].friction) - 1;
    const bool sticks = friction > 0 && contact.velocity.segment(1, friction).isZero(0);
    modes[i] = sticks ? ContactMode::stick : ContactMode::slip;
  }
  return modes;
}

MotionRecorder::MotionRecorder(const MechanicalSystem& system, const State& start, double t_end,
                               const IntegratorOptions& options, const Observer& observer,
                               const std::vector<ContactMode>& modes, RunReport& report)
    : system_(system),
      observer_(observer),
      report_(report),
      clock_(start.t, t_end, options.output_interval),
      modes_(modes),
      q_(start.q),
      u_(start.u) {
  report_.dissipated.assign(system.contacts().size(), {});
  report_.work.assign(system.works().size(), 0);
  show();
}

void MotionRecorder::show() {
  if (observer_) observer_({clock_.next(), q_, u_, modes_});
  clock_.advance();
}

RunReport& end_run(RunReport& report, RunStatus status, double t, const std::string& why) {
  report.status = status;
  report.message = "t = " + to_text(t) + " s: " + why;
  return report;
}

}  // namespace contensou
