#pragma once

#include <cmath>

namespace contensou {

/// What bracketed_newton needs to know at x.
struct NewtonStep {
  double value;  ///< positive left of the root, negative right of it
  double fall;   ///< minus its derivative; need not be positive away from the root
  bool stop;     ///< the caller has seen enough; `fall` is then not needed
};

/// Where it ended: x is where the function was evaluated last.
struct NewtonEnd {
  double x;
  int iterations;  ///< evaluations
};

/// Where the root is known to be: value > 0 at `low`, <= 0 at `high`.
struct Bracket {
  double low;
  double high;
};

/// The root of a function that is positive left of it and negative right of it, by Newton's method from
/// `guess` in the bracket, each step kept inside the bracket. Where Newton's step leaves it or has not halved
/// within two steps, the bracket is halved instead. Ends where the caller says so, where the next step is
/// below an ulp of x or the bracket is, or after `most_iterations`, whatever the function.
template <class Function>
NewtonEnd bracketed_newton(Bracket bracket, double guess, const Function& function) {
  constexpr double rounding = 0x1p-52;
  constexpr int most_iterations = 100;
  double x = guess;
  double last_step = bracket.high - bracket.low;
  double step_before = 2 * last_step;
  for (int i = 1;; ++i) {
    const NewtonStep at = function(x);
    if (at.stop || at.value == 0 || i == most_iterations) return {x, i};
    (at.value > 0 ? bracket.low : bracket.high) = x;
    const double next = x + at.value / at.fall;
    const double step = std::abs(next - x);
    if (bracket.high - bracket.low <= rounding * bracket.high || step <= rounding * x) return {x, i};
    const bool newton = at.fall > 0 && next > bracket.low && next < bracket.high && 2 * step <= step_before;
    const double half = (bracket.high - bracket.low) / 2;
    step_before = last_step;
    last_step = newton ? step : half;
    x = newton ? next : bracket.low + half;
  }
}

/// Where on [0, 1] a function h, known with its derivative −fall at both ends, is zero: the cubic Hermite
/// polynomial of the inverse function, or the secant where that is no use. h0 > 0 >= h1. In (0, 1], with the
/// relative accuracy of h0 for small h0.
inline double inverse_cubic(double h0, double fall0, double h1, double fall1) {
  const double drop = h0 - h1;
  const double q = h0 / drop;  // how far down, 0 to 1
  double x = q;
  if (fall0 > 0 && fall1 > 0) {
    const double a = drop / fall0;  // dx/dq at both ends
    const double b = drop / fall1;
    const double cubic = q * (a + q * (3 - 2 * a - b + q * (a + b - 2)));
    if (cubic > 0 && cubic <= 1) x = cubic;
  }
  return x;
}

}  // namespace contensou
