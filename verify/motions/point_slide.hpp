#pragma once

#include <Eigen/Core>

namespace known_motions {

/// ẇ = f e_x − d w/‖w‖ in the plane until w = 0, and w = 0 from then on: a block on an incline with Coulomb
/// friction that holds it at rest (d > f >= 0). It also is the contact velocity of a ball, with 7/2 of the
/// friction.
///
/// With ψ the angle from e_x to w and p = tan ψ/2, κ = d/f:
///     ‖w‖ = C p^(κ−1)(1 + p²)/2,    dt = −(C/2f) p^(κ−2)(1 + p²) dp,
/// and with that powers of p for time and path: the motion ends with p = 0, turned down the incline.
class PointSlide {
 public:
  struct Point {
    Eigen::Vector2d velocity;
    Eigen::Vector2d displacement;
  };

  /// w at t = 0 [m/s], not zero; pull f and friction d in m/s², d > f >= 0.
  PointSlide(const Eigen::Vector2d& velocity, double pull, double friction);

  double stopping_time() const;
  Point at(double t) const;

 private:
  Point at_turn(double p) const;
  double time(double p) const;

  Eigen::Vector2d start_;
  double pull_;
  double friction_;
  double straight_ = 0;  ///< deceleration where the motion is along a line, else zero
  double kappa_ = 0;
  double c_ = 0;
  double p_ = 0;  ///< at the start
};

}  // namespace known_motions
