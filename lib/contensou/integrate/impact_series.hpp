#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace contensou {

/// Watches impacts for a series that accumulates: intervals that shrink geometrically, in any pattern that
/// repeats after 1, 2, 3 or 6 impacts (one bouncing contact; two or three that take turns).
class ImpactSeries {
 public:
  void clear() { count_ = 0; }
  /// Notes an impact.
  void add(double t) {
    if (count_ == capacity) {
      for (std::size_t i = 1; i < capacity; ++i) times_[i - 1] = times_[i];
      --count_;
    }
    times_[count_++] = t;
  }
  /// When the impacts accumulate, if they look like it: three windows of six intervals, the ratio of their
  /// lengths less than one and the same to 5 %.
  std::optional<double> limit() const {
    if (count_ < capacity) return std::nullopt;
    const double first = times_[window] - times_[0];
    const double second = times_[2 * window] - times_[window];
    const double third = times_[3 * window] - times_[2 * window];
    const double ratio = third / second;
    constexpr double same = 0.05;
    if (!(ratio < 1 && second < first) || std::abs(second / first - ratio) > same * ratio) return std::nullopt;
    return times_[3 * window] + third * ratio / (1 - ratio);
  }

  /// How long the last 18 intervals took together; infinite where there were fewer.
  double span() const {
    return count_ < capacity ? std::numeric_limits<double>::infinity() : times_[3 * window] - times_[0];
  }

 private:
  static constexpr std::size_t window = 6;
  static constexpr std::size_t capacity = 3 * window + 1;
  std::array<double, capacity> times_{};
  std::size_t count_ = 0;
};

}  // namespace contensou
