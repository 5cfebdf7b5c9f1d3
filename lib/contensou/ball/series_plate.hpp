#pragma once

#include "contensou/ball/plate.hpp"
#include "contensou/ball/plate_series.hpp"
#include "contensou/ball/series_arc.hpp"

namespace contensou {

/// A friction plate as the paper writes it, LG03 (2.18), (3.19), or as its series go on: the set of
/// plate_series.hpp to the letter, a union of two convex pieces,
///     inner: ξ <= ξ*, left side <= 1,      outer: ξ > ξ*, left side <= 1 (as far as its border falls),
/// whose borders do not meet at ξ* but leave a step. A FrictionPlate; what the step costs:
/// - It is not convex. The projection is the nearest point (the nearer of the two pieces' projections):
///   it exists, is idempotent to rounding, but jumps where both are as near, so it is not non-expansive,
///   and LG03 (2.20) −γ_F ∈ N_B(λ_F) says something else than LG03 (4.12).
/// - At a step upwards (the outer piece begins higher than the inner one ends) the normal can point to
///   the axis: direction {−1, 0}, the one exception from Meridian's "both >= 0".
/// - `support` and `border` are those of the convex hull, which does not contain the border about the step.
/// - `ray`: the largest crossing, where a ray leaves and enters again.
/// Where friction is to be computed take SmoothPlate.
class SeriesPlate {
 public:
  /// Throws std::invalid_argument where the series are no plate: a piece without border up to its seam.
  explicit SeriesPlate(const PlateSeries& series);

  const PlateSeries& series() const { return series_; }
  Extent extent() const { return series_.extent; }
  double support(double v, double s) const;
  Friction border(double v, double s) const;
  PlateRay ray(double t, double tau) const;
  PlateProjection project(Meridian p, double size) const;
  double curvature_radius(const PlateProjection& q) const;

 private:
  bool contains(Meridian p, double size) const;
  PlateProjection onto_inner(Meridian p, double size) const;
  PlateProjection onto_outer(Meridian p, double size) const;

  PlateSeries series_;
  SeriesArc inner_;  ///< η over ξ
  SeriesArc outer_;  ///< ξ over η
};

}  // namespace contensou
