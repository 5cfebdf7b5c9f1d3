#pragma once

#include <Eigen/Core>

namespace known_motions {

/// A homogeneous ball of radius r on a plane inclined towards +x whose contact velocity γ_T and its integral
/// are known. The friction force F that changes v by F/m changes γ_T by 7/2 F/m, whatever the law, so that
///     v = v_0 + 5/7 a t e_x + 2/7 (γ_T − γ_T0),    a = g sin α,
/// sliding or rolling. From γ_T0 to rolling on a level plane: the 2/7 law.
struct BallSlide {
  Eigen::Vector2d start;    ///< v_0 [m/s]
  Eigen::Vector2d contact;  ///< γ_T at the start [m/s]
  double pull;              ///< a [m/s²]

  Eigen::Vector2d velocity(double t, const Eigen::Vector2d& gamma) const {
    return start + Eigen::Vector2d(5 * pull * t / 7, 0) + 2 * (gamma - contact) / 7;
  }
  /// `slid`: ∫γ_T dt from the start [m].
  Eigen::Vector2d displacement(double t, const Eigen::Vector2d& slid) const {
    return start * t + Eigen::Vector2d(5 * pull * t * t / 14, 0) + 2 * (slid - contact * t) / 7;
  }
  /// ω_x, ω_y from γ_T = (v_x − rω_y, v_y + rω_x).
  static Eigen::Vector2d spin(const Eigen::Vector2d& velocity, const Eigen::Vector2d& gamma, double r) {
    return {(gamma.y() - velocity.y()) / r, (velocity.x() - gamma.x()) / r};
  }
};

}  // namespace known_motions
