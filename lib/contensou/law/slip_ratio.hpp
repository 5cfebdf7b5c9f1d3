#pragma once

#include <cmath>
#include <stdexcept>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// The arguments at the door of every law: v, s >= 0, not both zero, not both infinite, no NaN.
/// Throws std::domain_error otherwise.
inline void require_slip(double v, double s) {
  if (!(v >= 0 && s >= 0)) throw std::domain_error("friction law: v and s must be numbers >= 0");
  if (v == 0 && s == 0)
    throw std::domain_error("friction law: at v = s = 0 the friction is a set, not a number");
  if (v == s && std::isinf(v)) throw std::domain_error("friction law: v and s are both infinite");
}

/// What the laws that depend on u = v/s only are made of, each bounded and away from zero for x in [0, 1].
/// Where v <= s (inner, x = v/s = u):     force = ξ/u, torque = η,   second = f''(u).
/// Where v > s  (outer, x = s/v = w = 1/u): force = ξ,   torque = η u, second = u³ f''(u).
struct BoundedForm {
  double force;
  double torque;
  double second;
};

/// min(v, s)/max(v, s) and its distance from 1, the latter without cancellation: what a law looks like near u
/// = 1 hangs on 1 − u, which x alone holds to 16 digits after the point only.
struct SlipRatio {
  double x;
  double gap;  // 1 − x
};

inline SlipRatio slip_ratio(double smaller, double larger) {
  if (std::isinf(larger)) return {0, 1};
  return {smaller / larger, (larger - smaller) / larger};
}

/// (v − s)/(v + s) for finite v and s, what the laws are expanded in about u = 1; for v and s of like size
/// two roundings.
inline double seam_distance(double v, double s) {
  const double sum = v + s;
  return std::isinf(sum) ? (v / 2 - s / 2) / (v / 2 + s / 2) : (v - s) / sum;
}

/// ξ, η from a law's bounded forms (functions of SlipRatio; anything with members force and torque).
template <class Inner, class Outer>
Friction friction_from(double v, double s, const Inner& inner, const Outer& outer) {
  require_slip(v, s);
  if (v <= s) {
    const SlipRatio u = slip_ratio(v, s);
    const auto form = inner(u);
    return {form.force * u.x, form.torque};
  }
  const SlipRatio w = slip_ratio(s, v);
  const auto form = outer(w);
  return {form.force, form.torque * w.x};
}

/// The second derivatives of a homogeneous law along the larger speed and across, from those along the
/// smaller one (`second`/larger): no step overflows or underflows before the result does.
struct SmallMixedLarge {
  double small;
  double mixed;
  double large;
};

inline SmallMixedLarge second_derivatives(double x, double smaller, double larger, double second) {
  // Where x² would leave the normal range, larger > 2^-1074/2^-500: then the quotient is far from overflow.
  // And where x itself is about to, so is the quotient by larger².
  constexpr double square_is_subnormal = 0x1p-500;
  constexpr double almost_subnormal = 0x1p-900;
  const double along = second / larger;
  if (x >= square_is_subnormal || smaller == 0 || std::isinf(larger)) {
    return {along, -(x * second) / larger, (x * x * second) / larger};
  }
  const double mixed = x >= almost_subnormal ? (x * second) / larger : smaller * (along / larger);
  return {along, -mixed, x * mixed};
}

/// Second derivatives of s f(v/s) from f''(u) inside and u³ f''(u) outside.
template <class Inner, class Outer>
Curvature curvature_from(double v, double s, const Inner& second_inner, const Outer& second_outer) {
  require_slip(v, s);
  if (v <= s) {
    const SlipRatio u = slip_ratio(v, s);
    const auto [vv, vs, ss] = second_derivatives(u.x, v, s, second_inner(u));
    return {vv, vs, ss};
  }
  const SlipRatio w = slip_ratio(s, v);
  const auto [ss, vs, vv] = second_derivatives(w.x, s, v, second_outer(w));
  return {vv, vs, ss};
}

}  // namespace contensou
