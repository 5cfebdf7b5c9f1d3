#pragma once

#include <algorithm>

#include "contensou/ball/smooth_plate.hpp"
#include "contensou/contact/secular.hpp"

namespace contensou::detail {

/// A slip ratio u, as x in [0, 1]: u = x for `inner`, u = 1/x else.
struct SlipPlace {
  bool inner;
  double x;
  bool operator<(const SlipPlace& other) const {
    if (inner != other.inner) return inner;
    return inner ? x < other.x : x > other.x;
  }
};

inline SlipPlace slip_place(double v, double s) {
  return v <= s ? SlipPlace{true, s > 0 ? v / s : 0} : SlipPlace{false, s / v};
}

/// Where x may have left [0, 1]: below zero it is zero, above one the other half begins.
inline SlipPlace slip_place_from(bool inner, double x) {
  return x <= 1 ? SlipPlace{inner, std::max(x, 0.0)} : SlipPlace{!inner, 1 / x};
}

/// Halfway between two places.
inline SlipPlace between(SlipPlace low, SlipPlace high) {
  if (low.inner == high.inner) return {low.inner, low.x + (high.x - low.x) / 2};
  return low.x < 1 ? SlipPlace{true, low.x + (1 - low.x) / 2} : SlipPlace{false, (1 + high.x) / 2};
}

/// A border point of the plate, the ellipsoid that touches there, and their derivatives by the place's x.
struct BorderPoint {
  Friction force;
  Friction d_force;
  Ellipsoid ellipsoid;
  double d_a;
  double d_c;
};

/// From the components across and along the normal's 1, and k = d across/dx.
inline BorderPoint border_point(SlipPlace place, double across, double along, double k) {
  const double x = place.x;
  constexpr double tiny = 1e-290;  // its inverse is finite
  constexpr double small = 1e-6;   // below it the difference in d_ratio is rounding
  const double inverse_across = 1 / across;
  const double inverse_along = 1 / along;
  const double ratio = x > tiny && across > tiny ? x * inverse_across : 1 / k;
  const double d_ratio = x > small ? (1 - k * ratio) * inverse_across : 0;
  // φ = x across + along, dφ = across.
  const double inverse_phi = 1 / (x * across + along);
  const double small_axis = ratio * inverse_phi;
  const double large_axis = inverse_along * inverse_phi;
  const double d_small = (d_ratio - small_axis * across) * inverse_phi;
  const double d_large = (x * k * inverse_along * inverse_along - large_axis * across) * inverse_phi;
  if (place.inner) return {{across, along}, {k, -x * k}, {small_axis, large_axis}, d_small, d_large};
  return {{along, across}, {-x * k, k}, {large_axis, small_axis}, d_large, d_small};
}

template <class Law>
Friction border_force(const Law& law, SlipPlace place) {
  return place.inner ? law.at(place.x, 1) : law.at(1, place.x);
}

/// By the law.
template <class Law>
BorderPoint exact_border(const Law& law, SlipPlace place) {
  const auto [xi, eta] = border_force(law, place);
  if (place.inner) return border_point(place, xi, eta, law.curvature(place.x, 1).vv);
  return border_point(place, eta, xi, law.curvature(1, place.x).ss);
}

/// By interpolation between the plate's stored points: a fraction of the law's price, good to some 1e-8 and
/// its derivatives to 1e-6.
template <class Law>
BorderPoint stored_border(const SmoothPlate<Law>& plate, SlipPlace place) {
  const BorderNode node = plate.interpolated(place.inner, place.x);
  return border_point(place, node.across, node.along, node.second);
}

/// The force by the law, derivatives by interpolation.
template <class Law>
BorderPoint refined_border(const SmoothPlate<Law>& plate, SlipPlace place) {
  const auto [xi, eta] = border_force(plate.law(), place);
  const double k = plate.interpolated(place.inner, place.x).second;
  return place.inner ? border_point(place, xi, eta, k) : border_point(place, eta, xi, k);
}

}  // namespace contensou::detail
