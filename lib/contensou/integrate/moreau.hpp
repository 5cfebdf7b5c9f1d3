#pragma once

#include "contensou/integrate/schemes.hpp"

namespace contensou {

/// `moreau`: Moreau's idea, contact and friction as inclusions on velocity level at the end of what is
/// stepped over, made second order where the motion is smooth.
///
/// While contacts stay what they are (open, slipping, sticking), a step is one of the SDIRK method of two
/// stages with γ = 1 − 1/√2 (R. Alexander, SIAM J. Numer. Anal. 14, 1977): L-stable, order two, and its last
/// stage is the step's end (stiffly accurate), so that there γ_N = 0 and the friction law hold exactly, stick
/// is stick and not an oscillation about it, and what is stiff in friction (near γ_F = 0 like 1/γ_τ) is
/// damped. Each stage is an inclusion for its own Λ (implicit_stage.hpp) with M, W and h where it is.
///
/// Where a mode changes in a stage, the step is made again as one of backward Euler, with the law at its end:
/// a Runge–Kutta method carries (1 − γ)/γ = 2.4 times what a contact does in the first stage into the second,
/// which throws a contact that just stopped slipping back the other way. Such steps have an error of O(Δt²)
/// in u where forces jump or kink (stick, opening), and are too few to be felt.
///
/// Where an open contact would end the step in the floor, it lands in it. When, is taken from the gaps at the
/// step's ends (linear between them); the step is made up to there, then an impact by the set-valued laws
/// with Newton's restitution, then one of backward Euler over what is left, with all contacts that were
/// closed or landed. So a body that lands inelastically comes to lie on the floor, and impulses are never
/// weighted. Several landings in one step share the time of the first. A bounce that the smooth forces of one
/// step end, ε_N|γ_N⁻| <= |Δγ_N|, is none: inelastic; and what backward Euler keeps on the floor after an
/// impact does not bounce at all. So bouncing comes to an end: impacts that accumulate are passed at the size
/// of a step.
///
/// After each step, gaps of closed contacts are set to zero by changes of q along M⁻¹w_N: in smooth steps by
/// O(Δt³), the drift of a constraint that is kept on velocity level.
///
/// Order: 2 in free flight, slip, stick and rolling, and through impacts that are apart; 1 in the time at
/// which impacts that accumulate have ended.
///
/// Dissipation is summed with the stages' laws and the method's weights, in steps of backward Euler as
/// −Λ·½(γ⁻ + γ⁺), exact for the change of kinetic energy, and from a landing to its step's end all as impact.
/// Events carry the time of the landing in their step, else of the step's end; a bounce is `close` and `open`
/// at one time. Shown inside a step is u as linear, q as cubic.
///
/// A contact radius may follow the load: it is that of each stage's own λ_N (implicit_stage.hpp), so the
/// order is the same. Impacts have the radius of Hertz's largest load.
///
/// The equations of a stage converge for Δt of up to about 3/‖∂(u̇, q̇)/∂(u, q)‖ (of a top: 3/ω); a longer one
/// ends the run, RunStatus::solver_failed, as does a contact problem that is not solved.
Scheme run_moreau;

/// `moreau_implicit`: the fully implicit version of Moreau's method of which LG03 Section 6 speaks: backward
/// Euler for q and u, h and W at the step's end, too. All else as `moreau`. First order. What oscillates with
/// ω is damped by (1 + ω²Δt²)^−½ each step, at the rate ω²Δt/2: so dies the nutation, by numbers and not by
/// friction. Converges for Δt up to about 1/‖∂(u̇, q̇)/∂(u, q)‖.
Scheme run_moreau_implicit;

}  // namespace contensou
