#pragma once

#include "contensou/ball/plate.hpp"
#include "contensou/law/approximations.hpp"

namespace contensou {

/// The plate of sliding and drilling friction that know nothing of each other: the rectangle ξ <= ξ_max,
/// η <= η_max; turned about the λ_τ axis, disk × interval. A FrictionPlate in closed form: no iteration, no
/// residual, points and gauges to an ulp. On the edge between side and top the normal found by `ray` is
/// (1, 1).
class RectanglePlate {
 public:
  /// Semi-axes in (0, ∞); throws std::invalid_argument otherwise.
  explicit RectanglePlate(Extent semi_axes) : law_(semi_axes) {}

  Extent extent() const { return law_.extent(); }
  double support(double v, double s) const { return v == 0 && s == 0 ? 0 : potential(law_, v, s); }
  Friction border(double v, double s) const { return law_.at(v, s); }
  PlateRay ray(double t, double tau) const;
  PlateProjection project(Meridian p, double size) const;
  double curvature_radius(const PlateProjection& q) const;

 private:
  DecoupledLaw law_;
};

}  // namespace contensou
