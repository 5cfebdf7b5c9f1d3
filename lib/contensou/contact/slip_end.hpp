#pragma once

#include <cmath>

#include "contensou/contact/slip_border.hpp"

namespace contensou::detail {

/// What the search for slip ends with.
template <int dimension>
struct SlipEnd {
  Eigen::Matrix<double, dimension, 1> friction;   ///< Λ_F
  double normal;                                  ///< Λ_N
  Eigen::Matrix<double, dimension, 1> direction;  ///< unit vector: where γ_F points
  bool found;
  bool sticks;  ///< σ = 0: the friction stops the contact and is not on the border
  int iterations;
};

/// A contact that sticks, Λ_F = −p/det.
template <int dimension>
void end_stick(const ReducedContact<dimension>& c, const Cramer<dimension>& at, SlipEnd<dimension>& end) {
  end.sticks = true;
  end.direction = at.p.normalized();
  end.friction = -at.p / at.det;
  end.normal = c.normal(end.friction);
  end.found = end.normal > 0;
}

/// Slip along `direction` with the friction −μΛ_N `unit`.
template <int dimension>
void end_slip(const ReducedContact<dimension>& c, const Eigen::Matrix<double, dimension, 1>& direction,
              const Eigen::Matrix<double, dimension, 1>& unit, SlipEnd<dimension>& end) {
  end.sticks = false;
  end.direction = direction;
  end.normal = c.n0 / (1 + c.mu * c.g.dot(unit));
  end.friction = -c.mu * end.normal * unit;
  end.found = end.normal > 0;
}

/// Slip at a place of the ball's border, its tangential part along p's.
template <class Law>
void end_slip(const Law& law, const ReducedContact<3>& c, SlipPlace place, const Eigen::Vector3d& p,
              SlipEnd<3>& end) {
  const double t = std::sqrt(p[0] * p[0] + p[1] * p[1]);
  const double e0 = t > 0 ? p[0] / t : 1;
  const double e1 = t > 0 ? p[1] / t : 0;
  const double sign = std::copysign(1.0, p[2]);
  const double length = std::sqrt(1 + place.x * place.x);
  const double v = (place.inner ? place.x : 1) / length;
  const double s = (place.inner ? 1 : place.x) / length;
  const auto [xi, eta] = border_force(law, place);
  end_slip<3>(c, {v * e0, v * e1, sign * s}, {xi * e0, xi * e1, sign * eta}, end);
}

}  // namespace contensou::detail
