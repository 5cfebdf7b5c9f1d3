#pragma once

#include <cmath>

namespace known_motions {

/// A point that falls on the plane z = 0 and bounces there with the restitution ε < 1, at rest after the
/// accumulation of its bounces.
class Bounces {
 public:
  struct Point {
    double z;
    double velocity;
  };

  /// From the height z >= 0 [m] with the velocity ż [m/s]; g > 0, 0 <= ε < 1.
  Bounces(double z, double velocity, double g, double restitution);

  /// Of impact k = 0, 1, ... [s]; for ε = 0 all impacts are the first.
  double impact_time(int k) const;
  /// t_0 + 2εv_0/((1 − ε)g), the time of infinitely many impacts [s].
  double accumulation_time() const;
  Point at(double t) const;

 private:
  double z_;
  double velocity_;
  double g_;
  double restitution_;
  double impact_speed_;  ///< of the first
};

}  // namespace known_motions
