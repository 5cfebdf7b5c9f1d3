#pragma once

#include "contensou/integrate/schemes.hpp"

namespace contensou {

/// The "Runge–Kutta 4 time-stepping method", LG03 Table 2, to the letter; what the letter is: printed.hpp.
/// options.step is Δt, shortened so that whole steps end at t_end.
///
/// Each stage is a step of Moreau's over Δt₂ = Δt/4, of which only the pseudo-acceleration
/// a_m = (u_E − u_A)/Δt₂ is kept. It is that of the configuration at q_m + Δt₂/2 u_m and of the contact
/// velocities Δt₂ later, not that of (t_m, q_m, u_m): an error of O(Δt) in each stage alike, which the
/// weights of the method of order four do not remove. It is so of the first order wherever M⁻¹h, W or
/// friction depend on q or the contact velocities; of order four where u̇ depends on u alone.
///
/// A stage stops the whole of a contact velocity γ within Δt₂: a_m = −4γ/Δt. So
/// - where contact is kept up in all stages, as in stick, a small γ obeys γ̇ = −4γ/Δt and is multiplied
///   in each step by 1 + z + z²/2 + z³/6 + z⁴/24 at z = −4, which is 5: no stability, until friction's bounds
///   end it;
/// - a body that hits the floor with −v leaves it with +v/3, though ε_N = 0: a_m = 4v/Δt in the stages that
///   find it approaching in the floor, and these are the first and the fourth, or the second (where it is the
///   fourth alone, the body is in the floor with −v/3, and leaves it a step later with +v/3, seldom +v/9);
///   However small Δt, what is dropped rises again to a ninth of its height: no convergence;
/// - a body comes to rest at a height of the size gΔt² over the floor, where some of the stages touch it.
/// Measured in tests/integrate/rk4_printed_test.cpp.
///
/// Energy that contacts take out is summed with the stages' forces and the method's weights. Shown between
/// the ends of a step is the method's natural continuous extension (of order 3 where the method has order 4).
/// A contact counts as closed that is so in any stage. Never fails; RunStatus::not_finite where the numbers
/// end.
Scheme run_rk4_printed;

}  // namespace contensou
