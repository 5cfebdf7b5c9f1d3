#pragma once

#include "contensou/integrate/motion.hpp"

namespace verify::integrators {

/// What one contact does all the time of a smooth motion.
enum class Kept {
  slip,  ///< λ_N from γ̇_N = 0, friction from Hertz's law
  roll,  ///< λ_N, λ_T from γ̇_N = 0, γ̇_T = 0
};

/// Where the motion ends if contact 0 keeps slipping or rolling: the contact forces put in by hand, by Runge,
/// Kutta and Fehlberg's method of order 8 in `steps` equal steps. No contact solver, no event, no integrator
/// of the library.
contensou::State smooth_reference(const contensou::MechanicalSystem& system, Kept kept,
                                  const contensou::State& start, double t_end, int steps);

}  // namespace verify::integrators
