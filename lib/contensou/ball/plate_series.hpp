#pragma once

#include <vector>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// The friction plate P_F (and, turned about the λ_τ axis, the friction ball B_F) as the paper writes it,
/// LG03 (2.18), (2.19), (3.19), (3.21): u eliminated from ξ(u), η(u) by power series about u = 0 and about u
/// = ∞. With ξ = ‖λ_T‖/(μλ_N) and η = λ_τ/(μλ_N), a force is admissible if
///
///     ξ <= ξ*:  (η/η_max)² + inner[0] ξ² + inner[1] ξ⁴ + ... <= 1
///     ξ >  ξ*:  ξ² + outer[0] η² + outer[1] η⁴ + ...         <= 1
///
/// Uniform pressure: both series stop converging exactly at the seam ξ*, the image of u = 1, where the law is
/// less smooth than a power series. Hertz pressure: the outer one does, the inner one a little beyond it,
/// at 1.026 ξ* (u² = 4/3). More terms help everywhere, but slowly at the seam, and the two pieces never quite
/// meet there: a truncated plate is not convex, with three terms not even closed. Where the exact plate is
/// wanted, take the law itself; this is what the paper prints, and what its series tend to. Largest distance
/// from the exact border, in μλ_N: uniform 1.8e-3 as printed, 1.6e-3 with the exact seam, 2.1e-5 with 20
/// terms; Hertz 1.5e-2 as printed, 3.3e-3 corrected, 5.1e-5 with 20 terms.
struct PlateSeries {
  Extent extent;              ///< semi-axes {1, η_max}: both pieces are exact on the axes
  double seam;                ///< ξ*
  std::vector<double> inner;  ///< coefficients of ξ², ξ⁴, ...
  std::vector<double> outer;  ///< coefficients of η², η⁴, ...
};

/// The plate of σ ∝ (1 − ρ²/R²)ⁿ to `terms` terms on either side (the paper prints three), with the seam
/// where it belongs, ξ* = (n + 3/2) Γ(n+2)²/Γ(n+5/2)² (8/(3π) for n = 0, 9π/32 for n = ½). The series of the
/// law, f = A ₂F₁(−½, −3/2−n; 1; u²) and u ₂F₁(−½, −½; 2+n; u⁻²), are inverted in 100 digits, so that every
/// coefficient is the nearest double or its neighbour. -1 < n <= 100, 1 <= terms <= 40; throws
/// std::invalid_argument otherwise.
PlateSeries plate_series(double n, int terms);

/// LG03 (2.18), (2.19) to the letter: uniform pressure, ξ* = 1 − 1/8 − 1/64. The coefficients are right; ξ*
/// is 1.2 % too large, because the three terms written of it are.
PlateSeries printed_uniform_plate();

/// LG03 (3.19), (3.21) to the letter: Hertz pressure, inner ξ⁶ coefficient 9/32768. It should be 729/32768,
/// which `plate_series(0.5, 3)` has.
PlateSeries printed_hertz_plate();

/// The left-hand sides: the inner piece, the outer piece,
/// and the one that holds at ξ. ξ >= 0; η of either sign.
double inner_side(const PlateSeries& plate, double xi, double eta);
double outer_side(const PlateSeries& plate, double xi, double eta);
double left_side(const PlateSeries& plate, double xi, double eta);

/// True if (ξ, η) belongs to the plate: left side <= 1.
bool contains(const PlateSeries& plate, double xi, double eta);

/// The border η >= 0 above ξ in [0, 1]: in closed form for ξ <= ξ*, else
/// the smallest root of the outer polynomial, to 2 ulp of its conditioning.
/// Jumps at ξ*. Throws std::domain_error for ξ outside [0, 1] or NaN.
double boundary_eta(const PlateSeries& plate, double xi);

/// The same from one piece alone, wherever ξ lies: what the jump at the seam is the difference of. Far
/// outside its range a piece may have no border: the inner one then gives 0, the outer one +∞.
double inner_boundary_eta(const PlateSeries& plate, double xi);
double outer_boundary_eta(const PlateSeries& plate, double xi);

}  // namespace contensou
