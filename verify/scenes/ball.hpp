#pragma once

#include "patch.hpp"

/// Homogeneous balls, 2/5 mr².
namespace verify::answers {

/// From slip γ_T = v − rω_y to rolling: whatever the friction force, v changes by −2/7 of what γ_T changes.
inline double rolling_speed(double v, double slip) { return v - 2 * slip / 7; }
/// Coulomb's friction: how long that takes [s].
inline double sliding_time(double slip, double mu, double g) { return 2 * slip / (7 * mu * g); }
/// κ of its slip and spin (slide_to_rest.hpp), a = 7/2 μg.
inline double kappa(double r, double patch_radius) { return 1.4 * r * r / (patch_radius * patch_radius); }

/// A ball in a groove of two planes at 45°, held there by symmetry or balance, spinning in place. Its
/// deceleration [rad/s²]:
///
/// about the vertical: both contacts carry mg/√2, slide with rω/√2 along the groove, one to and one fro, and
/// drill with ω/√2, so that u = r/R stays: friction and torque add to −μmg(r ξ + R η) about the vertical;
double groove_about_vertical(const Patch& patch, double r, double patch_radius, double mu, double g);
/// about the groove: friction loads one contact more than the other, N = mg(1 ± μ)/(√2(1 + μ²)), both slide
/// with rω, none drills (a patch is a point then): −√2 μmgr/(1 + μ²). μ < 1, else the ball climbs.
double groove_about_its_axis(double r, double mu, double g);

}  // namespace verify::answers
