#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace contensou {

/// The impacts of one contact, watched for a series that accumulates: intervals that shrink geometrically,
/// each (a bouncing ball, a body that rocks) or every second one.
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
  /// When the impacts accumulate, if they look like it: of three windows of two intervals the ratio of
  /// lengths is less than one, and the same to 5 %. If not, but all seven impacts fell within `unresolved`:
  /// at the last of them.
  std::optional<double> limit(double unresolved) const {
    if (count_ < capacity) return std::nullopt;
    const std::optional<double> last =
        times_[6] - times_[0] < unresolved ? std::optional(times_[6]) : std::nullopt;
    const double first = times_[2] - times_[0];
    const double second = times_[4] - times_[2];
    const double third = times_[6] - times_[4];
    const double ratio = third / second;
    constexpr double same = 0.05;
    if (!(ratio < 1 && second < first) || std::abs(second / first - ratio) > same * ratio) return last;
    return times_[6] + third * ratio / (1 - ratio);
  }

 private:
  static constexpr std::size_t capacity = 7;
  std::array<double, capacity> times_{};
  std::size_t count_ = 0;
};

}  // namespace contensou
