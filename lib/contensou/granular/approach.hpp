#pragma once

#include <Eigen/Core>
#include <vector>

#include "contensou/granular/pair_list.hpp"

namespace contensou {

/// A near pair as it is at one step: where, how far, how fast.
struct Approach {
  Eigen::Vector3d normal;      ///< n, from the second to the first
  Eigen::Vector3d arm, other;  ///< from the centres of mass to the contact [m]
  double gap;                  ///< g̃ [m]: at the step's start, by the tangent of where it is looked at
  double before, free;         ///< γ_N⁻ and γ_N at the end without contacts [m/s]
  double touching;             ///< gaps of this size count as none [m]

  /// γ_N with these velocities of the two bodies [m/s].
  double velocity(const Twist& first, const Twist& second) const {
    return normal.dot(first.v - second.v + first.omega.cross(arm) - second.omega.cross(other));
  }
};

/// All near pairs at the step that `motion` has begun, into `approach`, resized to them. The gap of spheres
/// is a convex function of where they are, so while bodies do not turn, g̃ + Δtγ_N is never more than the gap
/// at the end: what keeps the former from being negative keeps spheres out of each other, however fast.
void look_at(const PairList& list, const BodyMotion& motion, std::vector<Approach>& approach);

/// Gaps up to this part of the smaller radius count as zero. Between bodies that hold each other fast, gaps
/// of the size of rounding or of what the solver left are contradictory, and a law that insisted on closing
/// them would ask for impulses without bound. What is deeper is brought back by a tenth of it a step.
constexpr double touching_part = 1e-4;

/// c of the normal law 0 <= γ_N⁺ − c ⊥ Λ_N >= 0 [m/s]:
///     c = −g̃/Δt              where g̃ > s: the gap is not negative at the end of the step;
///     c = 0                   where |g̃| <= s, the size that counts as none;
///     c = −(g̃ + s)/(10Δt)     where it is deeper;
///     c = −ε_N γ_N⁻, if more,  where the contact would close in this step without impulses, and
///                             ε_N|γ_N⁻| > |γ_N_free − γ_N⁻|: Newton's law.
/// A bounce that the smooth forces of one step end is none.
double normal_target(const Approach& approach, double restitution, double dt);

/// Whether the contact closes at a speed that one step of the smooth forces does not explain: an impact.
bool is_impact(const Approach& approach);

}  // namespace contensou
