#include "contensou/integrate/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {
namespace {

/// h·rate at which the explicit methods become unstable is 2.8 (order 4) to 6 (order 8).
constexpr double stable = 2.0;
constexpr double limited_by_stability = 3.5;
/// Adaptive explicit steps are no longer than this: at the limit of stability the error control would let
/// them amplify roundings up to the tolerance, and slip would dance about its equilibrium.
constexpr double longest_stable = 4;
constexpr int first_patience = 8;
constexpr int longest_patience = 512;
/// An implicit step costs some four explicit ones.
constexpr double worth_implicit = 12;
constexpr int implicit_trial = 8;  ///< steps in which the implicit method may find its step size

constexpr double share_of_time_to_rest = 0.7;
/// Grid points nearer than this part of a step are met.
constexpr double on_grid = 1e-9;

// Of the step control, the usual ones.
constexpr double safety = 0.9;
constexpr double smallest_factor = 0.2;
constexpr double largest_factor = 6;
constexpr double factor_after_failure = 0.25;

}  // namespace

StepControl::StepControl(StepChoice choice, const IntegratorOptions& options, double t_start)
    : choice_(choice), step_(options.step), t_start_(t_start), patience_(first_patience) {}

double StepControl::propose(double t, double t_end, double time_to_rest) {
  double h = std::min(t_end - t, share_of_time_to_rest * time_to_rest);
  if (choice_ == StepChoice::fixed) {
    // An event may have been at a grid point, or just beyond.
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * std::abs(t);
    while (next_grid_time() - t <= std::max(on_grid * step_, rounding)) ++grid_;
    h = std::min(h, next_grid_time() - t);
  }
  if (choice_ == StepChoice::adaptive || rejected_) h = std::min(h, h_);
  return h;
}

bool StepControl::implicit(double h, double relaxation) {
  if (choice_ == StepChoice::fixed) return h * relaxation > stable;
  if (!implicit_) {
    limited_ = std::max(0, limited_ + (h * relaxation > limited_by_stability ? 2 : -1));
    if (limited_ >= 2 * patience_) {
      implicit_ = true;
      on_trial_ = implicit_trial;
    }
  } else if (on_trial_ > 0) {
    --on_trial_;
  } else if (h * relaxation < worth_implicit) {
    implicit_ = false;
    limited_ = 0;
    patience_ = std::min(2 * patience_, longest_patience);
  }
  return implicit_;
}

double StepControl::longest_explicit(double relaxation) const {
  return choice_ == StepChoice::adaptive ? longest_stable / relaxation
                                         : std::numeric_limits<double>::infinity();
}

bool StepControl::acceptable(double error) const {
  return choice_ == StepChoice::adaptive ? error <= 1 : std::isfinite(error);
}

void StepControl::scale(double h, double error, int order, double largest) {
  double factor = factor_after_failure;
  if (std::isfinite(error)) {
    factor =
        error > 0 ? std::clamp(safety * std::pow(error, -1.0 / order), smallest_factor, largest) : largest;
  }
  h_ = h * factor;
}

void StepControl::reject(double h, double error, int order) {
  scale(h, error, order, 1);
  rejected_ = true;
}

double StepControl::accept(double t, double h, double error, int order) {
  double reached = t + h;
  if (choice_ == StepChoice::adaptive) {
    // A step cut short for another reason says nothing against the longer one, unless its error does.
    constexpr double full = 0.999;
    constexpr double small_error = 0.1;
    if (h >= full * h_ || error > small_error) scale(h, error, order, rejected_ ? 1 : largest_factor);
  } else if (next_grid_time() - reached <= on_grid * step_) {
    reached = next_grid_time();
    ++grid_;
  }
  rejected_ = false;
  return reached;
}

void StepControl::interrupt(double h) {
  if (choice_ == StepChoice::fixed) rejected_ = false;
  h_ = std::max(h_, h);
}

}  // namespace contensou
