#pragma once

#include <Eigen/Core>
#include <limits>

namespace contensou::detail {

/// a⁻¹ b by elimination with full pivoting, n = 2, 3, 4. Pivots below `threshold` times the largest count as
/// zero, and the unknowns they stand for are zero.
template <int n>
Eigen::Matrix<double, n, 1> solve_pivoted(const Eigen::Matrix<double, n, n>& a,
                                          const Eigen::Matrix<double, n, 1>& b,
                                          double threshold = n * std::numeric_limits<double>::epsilon());

}  // namespace contensou::detail
