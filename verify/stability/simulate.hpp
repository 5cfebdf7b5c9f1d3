#pragma once

#include <Eigen/Core>
#include <functional>

#include "linearised.hpp"
#include "slipping_top.hpp"

namespace verify::stability {

/// What kept a simulation honest: the contact closed and slipping all the time.
struct Watch {
  bool finished = false;        ///< reached the end, contact closed throughout
  double least_normal = 1e300;  ///< λ_N/(mg)
  double largest_u = 0;         ///< ‖γ_T‖/(|ω|R)
  double largest_gap = 0;       ///< |g_N|, relative to the inclination times r
  double steps = 0;
};

/// Moves y from 0 to `duration` by DOP853 with error control and calls `seen` at count + 1 equidistant times.
Watch simulate(SlippingTop& top, Eigen::VectorXd& y, double duration, int count,
               const std::function<void(double t, const Eigen::VectorXd& y)>& seen);

/// Rate of growth of the inclination in the nonlinear top that starts in a mode: the slope of ln θ over time,
/// least squares, while the inclination grows or falls e²-fold at most or the spin loses 1 %.
struct Growth {
  double rate;
  double spin;         ///< in the middle of the time
  double spin_change;  ///< from start to end
  double duration;
  Watch watch;
};
Growth growth(const Setting& setting, double spin, const SlowMode& mode);

/// θ at the end over θ at the start of a top released tilted, without any velocity but its spin.
struct Fate {
  double ratio;
  Watch watch;
};
Fate fate(const Setting& setting, double spin, double duration);

}  // namespace verify::stability
