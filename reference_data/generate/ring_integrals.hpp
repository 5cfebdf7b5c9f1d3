#pragma once

#include "quantities.hpp"

namespace reference {

/// Force and torque alone (the second derivative has a logarithm at ρ = R* that defeats interval bounds).
struct ForceAndTorque {
  Ball force;   ///< scaled as in Scaled
  Ball torque;  ///< scaled as in Scaled
};

/// Third route, for n >= 0: the definition (2.1) in polar coordinates (ρ, φ) about
/// the middle of the contact, LG03 (2.2), (2.4), integrated rigorously ring by ring.
/// With x = α for ρ > R*, x = β for ρ < R* (2.3), K and E of modulus x, the integral
/// (2.5) is 4 [2E − (1−x²) K], and a ring of radius ρ (in units of R) carries
///
///   ρ < u:  ξ = (2/π) E,                 η = (2/π) u [E − (1−x²) K]
///   ρ > u:  ξ = (2/π) [E − (1−x²) K]/x,  η = (2/π) ρ E
///
/// times its share 2(n+1) ρ (1−ρ²)ⁿ dρ of λ_N. Shares no
/// coordinates, no prefactor and no formula with the chords.
ForceAndTorque by_ring_integrals(const Ball& n, const Argument& at);

}  // namespace reference
