#pragma once

#include "contensou/integrate/schemes.hpp"

namespace contensou {

/// Moreau's time-stepping method, LG03 (4.18), (4.19) and Table 1, to the letter; what the letter is:
/// printed.hpp. options.step is Δt, shortened so that whole steps end at t_end.
///
/// Of the first order where h depends on the velocity: h(t_M, q_M, u_A) has q and t of the midpoint, but u of
/// the start. Of the second order where h = h(t, q) alone, without friction. The friction of a step is that
/// of its end's velocity: first order.
///
/// Closed is what has g_N(q_M) <= 0, whatever remains of it at the end: a contact that closed stays as deep
/// in the floor as its last step took it, on average half a step of the impact's velocity.
///
/// Between the ends of a step, u is shown as linear and q as the two halves of the step have it. Never fails;
/// RunStatus::not_finite where the numbers end.
Scheme run_moreau_printed;

}  // namespace contensou
