#pragma once

#include "contensou/integrate/motion.hpp"

namespace contensou {

/// What is large and what is small in a motion: everything that integrators compare numbers with. From the
/// energy at hand, so that it has the right units whatever the coordinates.
struct MotionScales {
  double length;               ///< [m], the system's
  double time;                 ///< [s]: in which free acceleration moves coordinates by their scales
  double energy;               ///< [J]: kinetic energy, or what is gained in `time` from rest, the larger
  double speed;                ///< [m/s]: length/time or the fastest that `energy` can move a contact
  Eigen::VectorXd coordinate;  ///< n
  Eigen::VectorXd velocity;    ///< f: √(2 energy/M_ii)
};

/// Throws nothing; a system at rest that nothing accelerates has time 1 s and energy 1 J.
MotionScales motion_scales(const MechanicalSystem& system, const State& state);

/// The friction part of a contact's velocity (T1, T2, τ) as a speed: ‖(γ_T, ωL)‖ with the system's length L.
/// A patch however small then spins as fast as it does.
inline double slip_speed(const Eigen::Vector4d& gamma, double spin_factor) {
  const double spin = spin_factor * gamma[3];
  return std::sqrt(gamma[1] * gamma[1] + gamma[2] * gamma[2] + spin * spin);
}
/// L/R of a contact with drilling friction; 0 for others.
double spin_factor(const SystemContact& contact, double length);

}  // namespace contensou
