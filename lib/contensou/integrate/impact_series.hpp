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

  /// The shortest of the last six intervals, the longest of the last 18; infinite where there were fewer.
  double shortest() const { return extreme(window, [](double a, double b) { return a < b; }); }
  double longest() const { return extreme(3 * window, [](double a, double b) { return a > b; }); }

 private:
  static constexpr std::size_t window = 6;
  static constexpr std::size_t capacity = 3 * window + 1;

  template <class Better>
  double extreme(std::size_t intervals, const Better& better) const {
    if (count_ < intervals + 1) return std::numeric_limits<double>::infinity();
    double best = times_[count_ - 1] - times_[count_ - 2];
    for (std::size_t i = count_ - intervals; i + 1 < count_; ++i) {
      if (better(times_[i] - times_[i - 1], best)) best = times_[i] - times_[i - 1];
    }
    return best;
  }

  std::array<double, capacity> times_{};
  std::size_t count_ = 0;
};

}  // namespace contensou
