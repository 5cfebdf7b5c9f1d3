#include "contensou/contact/small_linear.hpp"

#include <Eigen/LU>

namespace contensou::detail {

template <int n>
Eigen::Matrix<double, n, 1> solve_pivoted(const Eigen::Matrix<double, n, n>& a,
                                          const Eigen::Matrix<double, n, 1>& b, double threshold) {
  return Eigen::FullPivLU<Eigen::Matrix<double, n, n>>(a).setThreshold(threshold).solve(b);
}

template Eigen::Vector2d solve_pivoted(const Eigen::Matrix2d&, const Eigen::Vector2d&, double);
template Eigen::Vector3d solve_pivoted(const Eigen::Matrix3d&, const Eigen::Vector3d&, double);
template Eigen::Vector4d solve_pivoted(const Eigen::Matrix4d&, const Eigen::Vector4d&, double);

}  // namespace contensou::detail
