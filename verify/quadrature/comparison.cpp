#include "comparison.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace verify {

void Comparison::add(double u, double oracle, double value, double bound) {
  double error = std::abs(value - oracle) / std::abs(oracle);
  if (std::isnan(error)) error = HUGE_VAL;
  ++count_;
  if (error > max_error_ || count_ == 1) {
    max_error_ = error;
    max_error_at_ = u;
  }
  // A bound that is no number bounds nothing.
  const double ratio = bound >= 0 ? error / bound : HUGE_VAL;
  if (ratio > tightest_ratio_) {
    tightest_ratio_ = ratio;
    tightest_ = {u, oracle, value, error, bound};
  }
}

Claim Comparison::claim(std::string id, std::string where, const std::string& sentence,
                        bool should_hold) const {
  Claim c;
  c.id = std::move(id);
  c.where = std::move(where);
  c.claim = sentence + "; " + std::to_string(count_) + " comparisons, largest relative error " +
            brief(max_error_) + " at u = " + brief_ratio(max_error_at_) +
            ", closest to its bound at u = " + brief_ratio(tightest_.u);
  c.expected = tightest_.oracle;
  c.obtained = tightest_.value;
  c.error = tightest_.error;
  c.bound = tightest_.bound;
  c.should_hold = should_hold;
  return c;
}

std::string brief(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

std::string brief_ratio(double u) {
  const double gap = u - 1;
  if (gap == 0 || std::abs(gap) > 1e-2) return brief(u);
  return (gap > 0 ? "1 + " : "1 - ") + brief(std::abs(gap));
}

}  // namespace verify
