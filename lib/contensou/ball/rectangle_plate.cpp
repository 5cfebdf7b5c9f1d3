#include "contensou/ball/rectangle_plate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {

PlateRay RectanglePlate::ray(double t, double tau) const {
  const double at_side = t / extent().xi;
  const double at_top = tau / extent().eta;
  if (at_side == at_top) return {at_side, {1, 1}, 0};
  return at_side > at_top ? PlateRay{at_side, {1, 0}, 0} : PlateRay{at_top, {0, 1}, 0};
}

PlateProjection RectanglePlate::project(Meridian p, double size) const {
  const Meridian corner{size * extent().xi, size * extent().eta};
  const double t = std::max(0.0, p.t - corner.t);
  const double tau = std::max(0.0, p.tau - corner.tau);
  if (t == 0 && tau == 0) return {p, {0, 0}, 0, 0, 0, true};
  const Meridian direction = t >= tau ? Meridian{1, tau / t} : Meridian{t / tau, 1};
  return {{std::min(p.t, corner.t), std::min(p.tau, corner.tau)}, direction, std::hypot(t, tau), 0, 0, false};
}

double RectanglePlate::curvature_radius(const PlateProjection& q) const {
  return q.direction.t > 0 && q.direction.tau > 0 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace contensou
