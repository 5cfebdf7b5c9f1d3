#pragma once

#include "quantities.hpp"

namespace reference {

/// Second route: the definition (2.1) in polar coordinates (r, θ) about the instantaneous centre of rotation,
/// LG03 (3.6) with the measure |r| dr, integrated rigorously (Petras' method in Arb).
///
/// On the chord at angle θ through the pole, q = r/R = u cos θ + √Δ s with Δ = 1 − u² sin² θ and −1 <= s <=
/// 1, so that 1 − ρ²/R² = Δ (1 − s²). The surface element at q slides with ‖w‖ = |ω| R |q| at right angles to
/// the chord; its share of the force along γ_T is cos θ sgn q, and the second derivative of ‖w‖ by v is sin²
/// θ/|q|. Integrating over s:
///
///   u <= 1 (0 <= θ <= π):
///     ξ/u = (n+1) B(½, n+1)/π   ∫ cos² θ Δ^{n+1/2} dθ
///     η   = (n+1) B(3/2, n+1)/π ∫ Δ^{n+3/2} dθ
///     f'' = (n+1) B(½, n+1)/π   ∫ sin² θ Δ^{n+1/2} dθ
///   u > 1, w = 1/u, sin θ = w sin a, −π/2 <= a <= π/2:
///     ξ      = (n+1) B(½, n+1)/π   ∫ cos^{2n+2} a √(1 − w² sin² a) da
///     u η    = (n+1) B(3/2, n+1)/π ∫ cos^{2n+4} a/√(1 − w² sin² a) da
///     u³ f'' = (n+1) B(½, n+1)/π   ∫ sin² a cos^{2n+2} a/√(1 − w² sin² a) da
///   u = 1: cos^{2n+3} in all three; the last by parts, ∫ sin² a cos^{2n+1} a da = ∫ cos^{2n+3} a da/(2n+2).
Scaled by_chord_integrals(const Ball& n, const Argument& at);

}  // namespace reference
