#pragma once

#include <limits>
#include <string>

#include "reference.hpp"

namespace accuracy {

/// |value − exact| in units in the last place of the double nearest to `exact` (the distance from that double
/// to the next larger one; the smallest subnormal for an exact 0). The exact value is not rounded first: a
/// correctly rounded result has an error of at most 0.5. NaN for NaN, infinity for an infinite value where
/// the exact one is finite.
double ulp_error(double value, const Quad& exact);

/// |value − exact|/|exact|; 0 where both are zero.
double relative_error(double value, const Quad& exact);

/// The errors of one quantity over one range of u.
class ErrorSummary {
 public:
  void add(double u, double error);

  /// The largest error; NaN as soon as one value was NaN.
  double max() const { return max_; }
  /// Over the values that are numbers.
  double mean() const;
  /// Where the largest error (or the first NaN) was.
  double worst_u() const { return worst_u_; }
  std::size_t points() const { return points_; }
  /// Values that were NaN, or infinite where the law is not.
  std::size_t not_finite() const { return not_finite_; }

 private:
  double max_ = 0;
  double sum_ = 0;
  double worst_u_ = std::numeric_limits<double>::quiet_NaN();
  std::size_t points_ = 0;
  std::size_t not_finite_ = 0;
};

}  // namespace accuracy
