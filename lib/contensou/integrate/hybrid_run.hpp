#pragma once

#include <string>
#include <vector>

#include "contensou/integrate/contact_dynamics.hpp"
#include "contensou/integrate/contact_instant.hpp"
#include "contensou/integrate/event_search.hpp"
#include "contensou/integrate/impact_series.hpp"
#include "contensou/integrate/motion_scales.hpp"
#include "contensou/integrate/radau5.hpp"
#include "contensou/integrate/sampling.hpp"
#include "contensou/integrate/step_control.hpp"

namespace contensou {

/// One integration from event to event: between them ContactDynamics by an explicit method (and Radau5 where
/// friction relaxes too fast for it, StepControl), at them ContactInstant.
///
/// Closings, openings and the end of stick are zeros of monitors (EventSearch). Slip that comes to rest has
/// none, since λ_F jumps there: steps follow it, never longer than 0.7 of the time it has left at its present
/// rate, until it is too slow to matter. Where the spin of a slipping contact changes its sign the motion is
/// smooth: recorded only.
///
/// Impacts that accumulate (ImpactSeries) are summed once bounces are too short for doubles, or for the error
/// control, to resolve: the contacts that take part close, at the limit of the series.
class HybridRun {
 public:
  HybridRun(const MechanicalSystem& system, State& state, double t_end, const IntegratorOptions& options,
            const Observer& observer, OdeStep& explicit_step, StepChoice choice);
  RunReport run();

 private:
  bool start();
  bool advance();
  bool take_step(OdeStep& stepper, double h, double error);
  bool take_event(OdeStep& stepper, double h, const EventSearch::Found& found);
  bool overrule(const EventSearch::Found& found);
  bool stop_slip(double h);
  bool settle(const std::string& cause, double t);
  bool go_on();
  bool close_accumulated();
  void order_events();
  bool fail(RunStatus status, const std::string& message);
  double smallest_step() const;

  void set_error_scales();
  void set_first_step();
  void load();
  void unload();
  void read_rates();
  void correct_drift();
  void record_spins(OdeStep& stepper, double h);
  void show_until(double t, OdeStep* stepper, double h);

  const MechanicalSystem& system_;
  State& state_;
  double t_end_;
  const IntegratorOptions& options_;
  const Observer& observer_;
  OdeStep& explicit_;
  Radau5 implicit_;
  StepControl control_;
  ContactDynamics dynamics_;
  ContactInstant instant_;
  MotionScales scales_;
  InstantTolerances tolerances_;
  SampleClock clock_;
  RunReport report_;

  std::vector<ContactMode> modes_, modes_before_;
  EventSearch events_;
  std::vector<ImpactSeries> impacts_;    ///< by contact
  std::vector<double> opened_, flight_;  ///< when a contact opened last, how long it then flew [s]
  double shortest_bounce_ = 0;           ///< [s]
  int stalled_ = 0;                      ///< events in a row without progress in time

  std::vector<double> spin_factor_;
  Eigen::VectorXd y_, rate_, scale_, shown_;
  Eigen::VectorXd shown_q_, shown_u_;
  std::int64_t evaluations_ = 0;  ///< after the attempt at hand
  double relaxation_ = 0;         ///< at y_, as are the next two
  double time_to_rest_ = 0;       ///< of slip that slows down, the shortest [s]
  double slowest_slip_ = 0;       ///< of all slip [m/s]
};

}  // namespace contensou
