#pragma once

#include "contensou/integrate/schemes.hpp"

namespace contensou {

/// `moreau` (moreau.hpp) with automatic step size. options.step is the first step tried.
///
/// Error: each step is made once whole and once in two halves; the halves are kept, and a third of the
/// difference is the estimate of what is wrong with them (order 2). It is measured, as the largest of
///   - the coordinates' errors in their scales (coordinate_scales),
///   - the velocities' error in the norm of kinetic energy, √(δuᵀMδu), in units of that of the fastest
///     motion so far,
/// and accepted up to options.tolerance. In smooth phases Δt goes like tolerance^⅓ and the error of the
/// result like tolerance^⅔.
///
/// Step size: proportional-integral control, Δt ← 0.9 Δt e^(−0.7/3) e_before^(0.4/3), by no more than 5 and
/// no less than 1/5; after a rejection 0.9 Δt e^(−1/3), no less than Δt/10.
///
/// Impacts and changes of mode are not smooth: the whole step and its halves see them at other times, and the
/// error does not shrink as it should. The step is reduced until the error passes or Δt is at the floor of
///     tolerance^⅓ × the longest step accepted so far,
/// at which a step with a change is accepted as it is: its error is then no worse than all that is smooth.
/// The same is done with a step that kept a contact closed which an impact had left open, or ended a bounce:
/// in that, whole step and halves may agree. From there the step size recovers in a few steps by factors
/// of 5. The floor never shrinks, so that accumulating impacts end at it. A smooth step may be shorter. The
/// run ends with RunStatus::step_too_small where the step no longer changes the time.
///
/// A contact that closes and opens again inside a step is not seen where gaps are positive at the ends of its
/// halves: what moves by polynomials of degree two has no error to keep steps short.
///
/// RunReport::steps counts the halves, rejected the pairs tried in vain.
Scheme run_moreau_adaptive;

}  // namespace contensou
