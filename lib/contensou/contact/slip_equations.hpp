#pragma once

#include <cmath>

#include "contensou/contact/slip_border.hpp"

namespace contensou::detail {

/// The two equations of a ball that slips, at a place x of the border and for σ (secular.hpp), with p = adj(a
/// + σD) b:
///   ratio = 1: the point is on the ellipsoid that touches the border at x;
///   value = (‖p_T‖η − |p_τ|ξ)/size = 0: it is where the ellipsoid touches.
/// `value` falls from the pole (u = 0) to the equator, at the root of `ratio`.
struct SlipEquations {
  Secular<3>::Point point;
  double value;
  double ratio_by_sigma, ratio_by_x;
  double value_by_sigma, value_by_x;  ///< with `size` kept
  Eigen::Vector3d p_by_sigma, p_by_x;
};

inline SlipEquations slip_equations(const Secular<3>& secular, const BorderPoint& border, double sigma,
                                    const Secular<3>::Point& point) {
  SlipEquations q;
  q.point = point;
  const Ellipsoid& e = border.ellipsoid;
  const Eigen::Vector3d& p = point.at.p;
  const double t = std::sqrt(p[0] * p[0] + p[1] * p[1]);
  const double tau = std::abs(p[2]);
  const double inverse_size = point.inverse_size;
  const double inverse_t = t > 0 ? 1 / t : 0;
  const double sign = std::copysign(1.0, p[2]);
  const auto moment = [&](const Eigen::Vector3d& dp) {  // what dp does to ‖p_T‖η − |p_τ|ξ
    return (p[0] * dp[0] + p[1] * dp[1]) * inverse_t * border.force.eta - sign * dp[2] * border.force.xi;
  };
  q.value = (t * border.force.eta - tau * border.force.xi) * inverse_size;
  q.ratio_by_sigma = secular.slope(e, sigma, point, e.a, e.c, q.p_by_sigma);
  q.value_by_sigma = moment(q.p_by_sigma) * inverse_size;
  const double kept = secular.slope(e, sigma, point, sigma * border.d_a, sigma * border.d_c, q.p_by_x);
  const double d_square = (border.d_a * t * t + border.d_c * tau * tau) * inverse_size * inverse_size;
  q.ratio_by_x = kept - point.ratio * d_square / 2;
  q.value_by_x = (moment(q.p_by_x) + t * border.d_force.eta - tau * border.d_force.xi) * inverse_size;
  return q;
}

}  // namespace contensou::detail
