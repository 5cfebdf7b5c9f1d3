#include "contensou/ball/friction_cylinder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contensou/ball/polar.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

constexpr double largest = std::numeric_limits<double>::max();
constexpr double least = std::numeric_limits<double>::denorm_min();

double magnitude(double tau) {
  if (!std::isfinite(tau)) detail::not_finite("friction cylinder");
  return std::abs(tau);
}

}  // namespace

FrictionCylinder::FrictionCylinder(double eta_max) : eta_max_(eta_max) {
  if (eta_max > 0 && std::isfinite(eta_max)) return;
  throw std::invalid_argument("friction cylinder: eta_max " + to_text(eta_max) + ", expected a number > 0");
}

double FrictionCylinder::half_height(double size) const { return std::min(eta_max_ * size, largest); }

double FrictionCylinder::support(double size, const Eigen::Vector3d& gamma) const {
  const double drilling = magnitude(gamma[2]);
  return disk_.support(size, gamma.head<2>()) + size * eta_max_ * drilling;
}

double FrictionCylinder::gauge(const Eigen::Vector3d& force) const {
  const double drilling = magnitude(force[2]) / eta_max_;
  return std::max(disk_.gauge(force.head<2>()), drilling);
}

bool FrictionCylinder::contains(const Eigen::Vector3d& force, double size) const {
  const double drilling = magnitude(force[2]);
  return disk_.contains(force.head<2>(), size) && drilling <= half_height(size);
}

Projection<3> FrictionCylinder::project(const Eigen::Vector3d& force, double size) const {
  const double drilling = magnitude(force[2]);
  const Projection<2> sliding = disk_.project(force.head<2>(), size);
  const double height = half_height(size);
  const double above = std::max(0.0, drilling - height);
  if (sliding.inside && above == 0) return {force, Eigen::Vector3d::Zero(), 0, 0, 0, true};
  Projection<3> q{};
  q.point << sliding.point, std::copysign(std::min(drilling, height), force[2]);
  // What is outside has a distance, however small.
  const double beside = sliding.inside ? 0 : std::max(sliding.distance, least);
  const double larger = std::max(beside, above);
  const double t = beside / larger;
  const double tau = above / larger;
  const double length = std::sqrt(t * t + tau * tau);
  q.normal << t / length * sliding.normal, std::copysign(tau / length, force[2]);
  q.distance = std::min(larger * length, largest);
  return q;
}

ProjectionDerivative<3> FrictionCylinder::derivative(const Projection<3>& q, const Eigen::Vector3d& force,
                                                     double size) const {
  ProjectionDerivative<3> d{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
  if (q.inside) return d;
  const Eigen::Vector2d force_t = force.head<2>();
  const auto sliding = disk_.derivative(disk_.project(force_t, size), force_t, size);
  d.force.topLeftCorner<2, 2>() = sliding.force;
  d.size.head<2>() = sliding.size;
  if (magnitude(force[2]) > half_height(size)) {
    d.force(2, 2) = 0;
    d.size[2] = std::copysign(eta_max_, force[2]);
  }
  return d;
}

}  // namespace contensou
