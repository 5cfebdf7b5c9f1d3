#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/system/tippe_top_model.hpp"

namespace bench {

/// One integrator at one setting, on one formulation of the tippe-top.
struct Scheme {
  contensou::Method method;
  std::string formulation;  ///< "axis" or "euler"
  double size;              ///< step [s] or tolerance
};

/// "axis, step 1e-04" and so on.
std::string setting(const Scheme& scheme);

/// The top of LG03 5.4 with Hertz pressure, in the formulation asked for.
std::unique_ptr<contensou::TippeTopModel> paper_top(const std::string& formulation);

constexpr double whole_motion = 8;  ///< [s]
constexpr double early_motion = 1;  ///< [s], before the first event: smooth

/// What one run tells of the motion of LG03 5.4. Times in s, angles in rad.
struct Story {
  /// Impacts before the accumulation: the tip touches, the body touches, and then each rocks the top back
  /// onto the other. What closes again without the other's having closed meanwhile is bouncing and counts
  /// once; what the body does in the second after the tip's touch counts as that touch.
  std::vector<double> impacts;
  /// Where the impacts end. Of a scheme that does not know accumulations: the last impact.
  double accumulation = 0;
  double theta = 0;  ///< θ(t)
  double t = 0;      ///< as far as it came
  std::int64_t steps = 0;
  std::string failure;  ///< why there is no such story to tell; empty where there is

  bool told() const { return failure.empty(); }
};

/// One run of `scheme` from the start to t_end; nothing is shown between the two. `top`: paper_top of its
/// formulation. Before the first event (t_end <= early_motion) no impacts are missed.
Story story_of(const contensou::TippeTopModel& top, const Scheme& scheme, double t_end);

/// What is wrong with a run. Times in s, angles in rad.
struct Errors {
  double events = 0;   ///< largest error of all impacts before the accumulation
  double touches = 0;  ///< of the first two, the tip's and the body's touch
  double accumulation = 0;
  double theta_early = 0;  ///< θ(1 s)
  double theta_end = 0;    ///< θ(8 s)
};

/// `event_driven` at its most exact, and how far to believe it.
struct Reference {
  Story whole;
  double theta_early;
  Errors bars;  ///< largest distance of the witnesses
  std::string witnesses;
};

/// The k-th impact against the k-th. Where a run has fewer, because it takes the last ones for one, these are
/// where its impacts end.
Errors errors(const Story& whole, double theta_early, const Reference& reference);

/// Throws std::runtime_error where a run it needs does not succeed.
Reference reference();

}  // namespace bench
