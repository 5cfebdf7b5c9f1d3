#pragma once

#include <string>
#include <vector>

#include "contensou/integrate/contact_dynamics.hpp"
#include "contensou/integrate/contact_instant.hpp"
#include "contensou/integrate/impact_series.hpp"
#include "contensou/integrate/motion_scales.hpp"
#include "contensou/integrate/radau5.hpp"
#include "contensou/integrate/sampling.hpp"

namespace contensou {

/// How a run chooses its steps.
enum class StepChoice {
  fixed,     ///< options.step, from grid point to grid point; shorter only for events
  adaptive,  ///< by the estimated error, options.tolerance
};

/// One integration from event to event: between them ContactDynamics by an explicit method (and Radau5 where
/// friction relaxes too fast for it), at them ContactInstant.
///
/// Events are the first zeros of the monitors: gaps of open contacts, normal forces of closed ones, what is
/// left of friction in those that stick. They are looked for on the continuous extension and then landed on
/// by a step of their length. Slip that comes to rest has no such monitor, since λ_F jumps there: steps
/// follow it, never longer than 0.7 of the time it has left at its present rate, until it is too slow to
/// matter. Where the spin of a slipping contact changes its sign the motion is smooth, and nothing is done.
///
/// Impacts that accumulate (ImpactSeries) are summed once bounces are too short for doubles, or for the error
/// control, to resolve: the contacts that take part close, at the limit of the series.
class HybridRun {
 public:
  HybridRun(const MechanicalSystem& system, State& state, double t_end, const IntegratorOptions& options,
            const Observer& observer, OdeStep& explicit_step, StepChoice choice);
  RunReport run();

 private:
  struct Found {
    double theta;           ///< in steps
    std::size_t monitor;
  };

  bool start();
  bool advance();
  bool settle(const std::string& cause, double t);
  bool close_accumulated();

  OdeStep& choose_stepper(double h);
  double longest_step() const;
  double next_grid_time() const;
  void adapt(double error, bool accepted, const OdeStep& stepper);

  void load();
  void set_error_scales();
  void unload(const Eigen::VectorXd& y, double t);
  void read_rates();
  void correct_drift();

  void monitor(double t, const Eigen::VectorXd& y, std::vector<double>& values) const;
  bool evaluate_between(OdeStep& stepper, double h, double theta, std::vector<double>& values);
  std::optional<Found> find_event(OdeStep& stepper, double h);
  double risen(OdeStep& stepper, std::size_t contact, double last, double h);
  double locate(OdeStep& stepper, double h, std::size_t monitor, double left, double right);
  bool land(OdeStep& stepper, double h, const Found& found);
  void arm();
  void show_until(double t, OdeStep* stepper, double h);

  const MechanicalSystem& system_;
  State& state_;
  double t_end_;
  const IntegratorOptions& options_;
  const Observer& observer_;
  OdeStep& explicit_;
  StepChoice choice_;
  Radau5 implicit_;
  ContactDynamics dynamics_;
  ContactInstant instant_;
  std::vector<ImpactSeries> impacts_;  ///< by contact
  std::vector<double> opened_, flight_;  ///< when a contact opened last, how long it then flew [s]
  double shortest_bounce_ = 0;           ///< [s]
  MotionScales scales_;
  InstantTolerances tolerances_{};
  SampleClock clock_;
  RunReport report_;

  std::vector<ContactMode> modes_, modes_before_;
  std::vector<bool> armed_;           ///< open contacts that have risen since they opened
  std::vector<double> spin_factor_;
  Eigen::VectorXd y_, rate_, scale_, between_, between_rate_;
  std::vector<double> at_start_, at_end_, at_theta_;

  double t_start_ = 0;
  std::int64_t grid_ = 0;  ///< grid steps done
  double h_ = 0;           ///< proposed
  bool rejected_ = false;
  bool use_implicit_ = false;
  int limited_ = 0;        ///< by two for each explicit step that stability limits, less one for each other
  int on_trial_ = 0;       ///< implicit steps before it is asked whether they pay
  int patience_ = 8;
  double relaxation_ = 0;  ///< at y_
  double time_to_rest_ = 0;
  double slowest_slip_ = 0;
  int stalled_ = 0;        ///< events in a row without progress in time
};

}  // namespace contensou
