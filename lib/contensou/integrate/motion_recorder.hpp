#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/integrate/sampling.hpp"

namespace contensou {

/// The equal steps of the fixed-step schemes: the least number of them that are not longer than the step
/// asked for (a part in 10¹² is rounding), so that the last one ends at `end` to the last bit.
struct EqualSteps {
  double start;
  double end;
  std::int64_t count;

  EqualSteps(double from, double to, double step);
  double step() const { return count == 0 ? 0 : (end - start) / static_cast<double>(count); }
  /// Of the end of step k, k = 1 to count.
  double time(std::int64_t k) const {
    return k == count ? end : start + (end - start) * (static_cast<double>(k) / static_cast<double>(count));
  }
};

/// What a contact is at the start, by its gap and velocities alone: closed where g_N is zero within rounding
/// and γ_N, too; sticking where γ_F is exactly zero.
std::vector<ContactMode> modes_at_start(const MechanicalSystem& system, const State& state);

/// Keeps what time-stepping schemes have in common to tell: shows the motion to the observer and writes
/// events and work into the report. Both outlive it.
class MotionRecorder {
 public:
  /// Shows the start. `modes`: at the start.
  MotionRecorder(const MechanicalSystem& system, const State& start, double t_end,
                 const IntegratorOptions& options, const Observer& observer,
                 const std::vector<ContactMode>& modes, RunReport& report);

  const std::vector<ContactMode>& modes() const { return modes_; }

  /// A step from t0 to t1 was accepted: counts it, records at t_events what changed to `modes` and which
  /// contacts `bounced` (closed and opened), and shows what is to be shown in (t0, t1]. interpolate(θ, q, u)
  /// writes the motion at t0 + θ(t1 − t0).
  template <class Interpolate>
  void accept(double t0, double t1, const std::vector<ContactMode>& modes, const Interpolate& interpolate,
              double t_events, const std::vector<std::size_t>& bounced) {
    ++report_.steps;
    for (const std::size_t i : bounced) {
      report_.events.push_back({t_events, EventKind::close, i});
      report_.events.push_back({t_events, EventKind::open, i});
    }
    for (std::size_t i = 0; i < modes.size(); ++i)
      record_change(t_events, i, modes_[i], modes[i], report_.events);
    modes_ = modes;
    while (clock_.next() <= t1) {
      interpolate((clock_.next() - t0) / (t1 - t0), q_, u_);
      system_.restore(q_);
      show();
    }
  }

  /// The same where nothing bounced and events are at the step's end.
  template <class Interpolate>
  void accept(double t0, double t1, const std::vector<ContactMode>& modes, const Interpolate& interpolate) {
    accept(t0, t1, modes, interpolate, t1, {});
  }

 private:
  void show();

  const MechanicalSystem& system_;
  const Observer& observer_;
  RunReport& report_;
  SampleClock clock_;
  std::vector<ContactMode> modes_;
  Eigen::VectorXd q_, u_;
};

/// Ends a run: status, message, and what is returned.
RunReport& end_run(RunReport& report, RunStatus status, double t, const std::string& why);

}  // namespace contensou
