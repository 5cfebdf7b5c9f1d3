#pragma once

#include <cstdint>

#include "contensou/integrate/motion.hpp"

namespace contensou {

/// How a run chooses its steps.
enum class StepChoice {
  fixed,     ///< options.step, from grid point to grid point; shorter only for events
  adaptive,  ///< by the estimated error, options.tolerance
};

/// The next step's length and which method takes it: an explicit one as long as its stability does not limit
/// it, else an implicit one.
class StepControl {
 public:
  StepControl(StepChoice choice, const IntegratorOptions& options, double t_start);

  StepChoice choice() const { return choice_; }
  /// Adaptive: the first step to try.
  void set_first(double h) { h_ = h; }

  /// The step from t on: no further than `t_end`, the next grid point and 0.7 of `time_to_rest`, in which
  /// slip comes to rest at its present rate. It may be too short to be told from zero.
  double propose(double t, double t_end, double time_to_rest);
  /// Whether the step is one for the implicit method; `relaxation` is the fastest rate at which friction
  /// brings slip to its equilibrium [1/s]. Asked once for each step tried.
  bool implicit(double h, double relaxation);

  /// The longest step that the explicit method may take; infinite for fixed steps.
  double longest_explicit(double relaxation) const;

  bool acceptable(double error) const;
  /// `error` is that of the attempt, infinite where there was none; `order` its power of h.
  void reject(double h, double error, int order);
  /// Returns the time reached: grid points are met to the last bit.
  double accept(double t, double h, double error, int order);
  /// The step ended at an event after h: the next one is as long as this one was to be.
  void interrupt(double h);

 private:
  double next_grid_time() const { return t_start_ + static_cast<double>(grid_ + 1) * step_; }
  void scale(double h, double error, int order, double largest);

  StepChoice choice_;
  double step_;
  double t_start_;
  std::int64_t grid_ = 0;  ///< grid steps done
  double h_ = 0;           ///< adaptive: proposed; fixed: the longest after a rejection
  bool rejected_ = false;
  bool implicit_ = false;
  int limited_ = 0;   ///< by two for each explicit step that stability limits, less one for each other
  int on_trial_ = 0;  ///< implicit steps before it is asked whether they pay
  int patience_;
};

}  // namespace contensou
