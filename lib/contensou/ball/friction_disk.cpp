#include "contensou/ball/friction_disk.hpp"

#include <cmath>
#include <stdexcept>

namespace contensou {
namespace {

void require_size(double size) {
  if (!(size >= 0 && std::isfinite(size))) {
    throw std::invalid_argument("friction disk: its size mu*lambda_N must be a finite number >= 0");
  }
}

double length(const Eigen::Vector2d& x) {
  const double square = x[0] * x[0] + x[1] * x[1];
  if (square > 0x1p-900 && square < 0x1p1000) return std::sqrt(square);
  const double result = std::hypot(x[0], x[1]);
  if (!(std::isfinite(x[0]) && std::isfinite(x[1]))) {
    throw std::domain_error("friction disk: a force or velocity is not finite");
  }
  return result;
}

}  // namespace

double FrictionDisk::support(double size, const Eigen::Vector2d& gamma) const {
  require_size(size);
  return size * length(gamma);
}

double FrictionDisk::gauge(const Eigen::Vector2d& force) const { return length(force); }

bool FrictionDisk::contains(const Eigen::Vector2d& force, double size) const {
  require_size(size);
  return length(force) <= size;
}

Projection<2> FrictionDisk::project(const Eigen::Vector2d& force, double size) const {
  require_size(size);
  const double l = length(force);
  if (l <= size) return {force, Eigen::Vector2d::Zero(), 0, 0, 0, true};
  const Eigen::Vector2d normal = force / l;
  return {size * normal, normal, l - size, 0, 0, false};
}

ProjectionDerivative<2> FrictionDisk::derivative(const Projection<2>& q, const Eigen::Vector2d& force,
                                                 double size) const {
  if (q.inside) return {Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero()};
  const Eigen::Vector2d around(-q.normal[1], q.normal[0]);
  return {size / length(force) * around * around.transpose(), q.normal};
}

}  // namespace contensou
