#pragma once

#include "contensou/integrate/motion.hpp"

/// The integrators behind `integrate`, one function a scheme, each described in a header of its own. They are
/// called with arguments that `integrate` has checked, with coordinates restored, and move `state` on.
namespace contensou {

/// Gaps of this size, relative to length_scale(), are closed at the start.
inline constexpr double closed_at_start = 1e-12;

using Scheme = RunReport(const MechanicalSystem& system, State& state, double t_end,
                         const IntegratorOptions& options, const Observer& observer);

Scheme run_moreau_printed;
Scheme run_rk4_printed;
Scheme run_moreau;
Scheme run_moreau_implicit;
Scheme run_moreau_adaptive;
Scheme run_rk4;
Scheme run_event_driven;

}  // namespace contensou
