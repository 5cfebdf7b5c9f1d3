#include "contensou/granular/gyration.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace contensou {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double longest_turn = 0.25;  // [rad] of a substep: Newton's method is certain and quick
constexpr double most_substeps = 64;
constexpr int most_iterations = 12;

Matrix3d cross_matrix(const Vector3d& a) {
  Matrix3d m;
  m << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return m;
}

Vector3d substep(const Vector3d& inertia, const Vector3d& start, double dt) {
  Vector3d middle = start;
  for (int i = 0; i < most_iterations; ++i) {
    const Vector3d momentum = inertia.cwiseProduct(middle);
    const Vector3d defect = inertia.cwiseProduct(middle - start) + dt / 2 * middle.cross(momentum);
    Matrix3d jacobian = dt / 2 * (cross_matrix(middle) * inertia.asDiagonal() - cross_matrix(momentum));
    jacobian.diagonal() += inertia;
    const Vector3d step = jacobian.inverse() * defect;
    middle -= step;
    if (!(step.squaredNorm() > 1e-32 * middle.squaredNorm())) break;
  }
  // Energy to rounding, also where the last digits of the iteration are not.
  const Vector3d end = 2 * middle - start;
  const double before = start.cwiseAbs2().dot(inertia);
  const double after = end.cwiseAbs2().dot(inertia);
  return after > 0 && std::isfinite(after) ? Vector3d(end * std::sqrt(before / after)) : start;
}

}  // namespace

Vector3d gyrated(const Vector3d& inertia, const Vector3d& omega, double dt) {
  const double turn = omega.norm() * dt;
  if (turn == 0) return omega;
  const double count = std::clamp(std::ceil(turn / longest_turn), 1.0, most_substeps);
  Vector3d end = omega;
  for (double i = 0; i < count; ++i) end = substep(inertia, end, dt / count);
  return end;
}

}  // namespace contensou
