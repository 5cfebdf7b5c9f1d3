#pragma once

#include <cmath>

namespace contensou {

/// What bracketed_newton needs to know at x.
struct NewtonStep {
  double value;  ///< positive left of the root, negative right of it
  double fall;   ///< minus its derivative; need not be positive away from the root
  bool stop;     ///< the caller has seen enough
};

/// Where it ended.
struct NewtonEnd {
  double x;
  int iterations;
  bool stopped;  ///< by the caller
};

/// The root in (0, 1] of a function that is positive left of it and negative right of it, by Newton's method
/// from `guess` in (0, 1], each step kept inside the bracket. Where Newton's step leaves the bracket or has
/// not halved within two steps, the bracket is halved instead: at most `most_iterations`, whatever the function.
/// The last step is smaller than 2^-28 x, so that what is left of it after a quadratic step is rounding.
template <class Function>
NewtonEnd bracketed_newton(double guess, const Function& function) {
  constexpr double small_step = 0x1p-28;
  constexpr double rounding = 0x1p-52;
  constexpr int most_iterations = 200;
  double low = 0;
  double high = 1;
  double x = guess;
  double last_step = 1;
  double step_before = 1;
  for (int i = 1;; ++i) {
    const NewtonStep at = function(x);
    if (at.stop) return {x, i, true};
    if (at.value == 0 || i == most_iterations) return {x, i, false};
    (at.value > 0 ? low : high) = x;
    if (high - low <= rounding * high) return {x, i, false};
    const double next = x + at.value / at.fall;
    const double step = std::abs(next - x);
    const bool newton = at.fall > 0 && next > low && next <= high && 2 * step <= step_before;
    if (newton && step <= small_step * x) return {next, i, false};
    step_before = last_step;
    last_step = newton ? step : (high - low) / 2;
    x = newton ? next : low + (high - low) / 2;
  }
}

}  // namespace contensou
