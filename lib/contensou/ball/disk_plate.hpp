#pragma once

#include "contensou/ball/plate.hpp"

namespace contensou {

/// The plate of Coulomb's point friction, LG03 (2.15), seen in three dimensions: the segment ξ <= 1, η = 0,
/// which bears no torque. Turned about the λ_τ axis, a flat disk: it has no interior, a torque is outside it
/// at any size (gauge infinite), and its normals under a force within it are ±(0, 0, 1). For two rows instead
/// of three, see friction_disk.hpp. A FrictionPlate in closed form, to an ulp.
class DiskPlate {
 public:
  Extent extent() const { return {1, 0}; }
  double support(double v, double /*s*/) const { return v; }
  Friction border(double v, double /*s*/) const { return {v > 0 ? 1.0 : 0.0, 0}; }
  PlateRay ray(double t, double tau) const;
  PlateProjection project(Meridian p, double size) const;
  double curvature_radius(const PlateProjection& q) const;
};

}  // namespace contensou
