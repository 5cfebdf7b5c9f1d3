#pragma once

#include <cmath>
#include <limits>

namespace verify {

/// The largest of some errors: NaN as long as there is none (which fails every claim), infinite once one of
/// them is NaN.
class Worst {
 public:
  Worst() = default;
  /// Starts at a value that stands where there are no errors.
  explicit Worst(double none) : value_(none) {}
  /// Whether it is the largest so far.
  bool add(double error) {
    if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
    if (error <= value_) return false;
    value_ = error;
    return true;
  }
  double value() const { return value_; }

 private:
  double value_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace verify
