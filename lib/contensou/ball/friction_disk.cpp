#include "contensou/ball/friction_disk.hpp"

#include "contensou/ball/polar.hpp"

namespace contensou {
namespace {

constexpr const char* name = "friction disk";

detail::Polar polar(const Eigen::Vector2d& x) { return detail::polar(x[0], x[1], name); }

}  // namespace

double FrictionDisk::support(double size, const Eigen::Vector2d& gamma) const {
  detail::require_size(size, name);
  return size * polar(gamma).length();
}

double FrictionDisk::gauge(const Eigen::Vector2d& force) const { return polar(force).length(); }

bool FrictionDisk::contains(const Eigen::Vector2d& force, double size) const {
  detail::require_size(size, name);
  const detail::Polar p = polar(force);
  return p.mantissa <= p.shrunk(size);
}

Projection<2> FrictionDisk::project(const Eigen::Vector2d& force, double size) const {
  detail::require_size(size, name);
  const detail::Polar p = polar(force);
  const double radius = p.shrunk(size);
  if (p.mantissa <= radius) return {force, Eigen::Vector2d::Zero(), 0, 0, 0, true};
  const Eigen::Vector2d normal(p.e1, p.e2);
  return {size * normal, normal, p.grown(p.mantissa - radius), 0, 0, false};
}

ProjectionDerivative<2> FrictionDisk::derivative(const Projection<2>& q, const Eigen::Vector2d& force,
                                                 double size) const {
  if (q.inside) return {Eigen::Matrix2d::Identity(), Eigen::Vector2d::Zero()};
  const Eigen::Vector2d around(-q.normal[1], q.normal[0]);
  const detail::Polar p = polar(force);
  return {p.shrunk(size) / p.mantissa * around * around.transpose(), q.normal};
}

}  // namespace contensou
