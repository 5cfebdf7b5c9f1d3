#pragma once

#include <string>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/system/tippe_top_model.hpp"

namespace verify::integrators {

/// The nutation's amplitude in equal windows of little more than its period: the root of the mean square of
/// ‖ė‖ = ‖ω × e‖, e the axis, [rad/s]. In free flight that is constant; on the floor the slow precession adds
/// little to it.
struct Nutation {
  static constexpr double window = 0.05;  ///< [s]
  std::vector<double> middle;             ///< of the windows [s]
  std::vector<double> amplitude;
  bool finished = false;
  std::string why;
  contensou::State end;
  contensou::RunReport report;
};
Nutation nutation(const contensou::TippeTopModel& top, const contensou::State& start, double duration,
                  contensou::Method method, double setting);

/// The angular frequency at which ė turns.
double nutation_frequency(const contensou::TippeTopModel& top, const contensou::State& start,
                          double duration);

/// Slope of ln(amplitude/of the reference) over time up to `until` [1/s], least squares. NaN where fewer than
/// three windows are there.
double rate_beside(const Nutation& measured, const Nutation& reference, double until);

}  // namespace verify::integrators
