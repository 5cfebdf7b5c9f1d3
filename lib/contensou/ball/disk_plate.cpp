#include "contensou/ball/disk_plate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {

PlateRay DiskPlate::ray(double t, double tau) const {
  if (tau > 0) return {std::numeric_limits<double>::infinity(), {0, 1}, 0};
  return {t, {1, 0}, 0};
}

PlateProjection DiskPlate::project(Meridian p, double size) const {
  const double t = std::max(0.0, p.t - size);
  if (t == 0 && p.tau == 0) return {p, {0, 0}, 0, 0, 0, true};
  const Meridian direction = t >= p.tau ? Meridian{1, p.tau / t} : Meridian{t / p.tau, 1};
  return {{std::min(p.t, size), 0}, direction, std::hypot(t, p.tau), 0, 0, false};
}

double DiskPlate::curvature_radius(const PlateProjection& q) const {
  return q.direction.t > 0 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace contensou
