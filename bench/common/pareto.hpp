#pragma once

#include <algorithm>
#include <cmath>

namespace bench {

/// What one method costs and gives.
struct Cost {
  double error;
  double seconds;
};

/// Errors below this are rounding in the last digits (about 4 units in the last place of 1): written as they
/// are, ranked as equal.
constexpr double rounding = 1e-15;

/// Whether `a` is both at least as exact and as fast as `b`, and one of the two better.
inline bool beats(const Cost& a, const Cost& b) {
  const double error_a = std::max(a.error, rounding);
  const double error_b = std::max(b.error, rounding);
  return error_a <= error_b && a.seconds <= b.seconds && (error_a < error_b || a.seconds < b.seconds);
}

/// The larger of the two errors; a NaN, once met, stays.
inline double worse(double a, double b) { return a >= b || std::isnan(a) ? a : b; }

}  // namespace bench
