#pragma once

#include <array>
#include <complex>
#include <optional>

#include "contensou/law/friction_law.hpp"
#include "contensou/system/tippe_top_model.hpp"

/// LG03 5.5: the linear stability of a top that spins about its vertical axis of symmetry on a spherical end,
/// closed form and eigenvalues. The spin ω is taken as constant, the deviations as so small that the contact
/// slips with u = v/(|ω|R) << 1: for an inclination θ that is θ << R/r.
namespace contensou {

/// One of the two positions. S is the centre of mass.
struct SpinningPosition {
  double m;   ///< [kg] > 0
  double i1;  ///< [kg m²] > 0, across the axis
  double i3;  ///< [kg m²] > 0, about the axis
  double g;   ///< [m/s²] > 0
  double a;   ///< height of the sphere's centre above S in this position [m], < r
  double r;   ///< radius of the sphere [m] > 0

  double h() const { return r - a; }  ///< height of S above the floor [m] > 0
};

SpinningPosition trivial_position(const TippeTopData& top);   ///< θ = 0 on the body: a = a1, r = r1
SpinningPosition inverted_position(const TippeTopData& top);  ///< θ = π on the tip: a = −a2, r = r2

/// ∂ξ/∂u at u = 0 of a law: 1 for the uniform pressure, 3π/8 for Hertz, (n+1) B(½, n+1)/2 for power n.
template <FrictionLaw L>
double initial_slope(const L& law) {
  return law.curvature(0.0, 1.0).vv;
}
/// What LG03 (5.24), (5.25) print for the Hertz law in the place of 3π/8.
inline constexpr double printed_initial_slope = 0.11936620731892150;  // 3/(8π)

/// A contact that spins fast and slips slowly.
struct SlowSlip {
  double mu;      ///< > 0
  double radius;  ///< R [m] > 0
  double slope;   ///< initial_slope of the law
};
/// ε [N s/m] of λ_T = −ε γ_T, LG03 (5.24), (5.25): μ m g slope/(|ω|R), for ω ≠ 0 [rad/s].
double slip_damping(const SpinningPosition& position, const SlowSlip& contact, double omega);

/// The left-hand side of LG03 (5.31), constant term first, for spin ω and damping ε; and with what the
/// paper's (5.22) leaves out: the drilling torque `drilling` >= 0 [N m] (η(0) μ m g R) against the spin. It
/// acts about the vertical, so it has a part across the inclined axis, and amg becomes amg +
/// i·sgn(ω)·drilling.
using CharacteristicCubic = std::array<std::complex<double>, 4>;
CharacteristicCubic characteristic_cubic(const SpinningPosition& position, double omega, double epsilon,
                                         double drilling = 0);

/// The three roots of the cubic [1/s] in descending order of real part, each to rounding of its own
/// condition. Throws std::invalid_argument for numbers that are not finite or a leading coefficient zero.
std::array<std::complex<double>, 3> eigenvalues(const CharacteristicCubic& cubic);

/// The two that stay finite for R → 0, LG03 (5.37): pure rolling. First the one with the + sign.
std::array<std::complex<double>, 2> rolling_eigenvalues(const SpinningPosition& position, double omega);

/// The left-hand side of LG03 (5.33) [N m]. Positive: asymptotically stable for every ε > 0; negative:
/// unstable for every ε > 0 (Hermite–Biehler: the cubic at λ = iν is ε p₂(ν) + i mν p₁(ν) with real
/// quadratics p₁, p₂ that agree at ν = rω/h; their zeros interlace as they must if and only if both are
/// positive there). Valid for ω ≠ 0 and a ≠ 0.
double stability_margin(const SpinningPosition& position, double omega);

/// Magnus's diagram, LG03 Fig. 11. The borders h/r = 1 and h/r = I₁/I₃ belong to no region.
enum class MagnusRegion {
  i,     ///< unstable at every spin
  ii,    ///< stable above the critical spin
  iii,   ///< stable at every spin
  iv,    ///< stable below the critical spin
  none,  ///< on a border
};
const char* name(MagnusRegion region);  ///< "I" and so on; "none"
/// For h/r > 0 and I₃/I₁ > 0.
MagnusRegion magnus_region(double h_over_r, double i3_over_i1);
MagnusRegion magnus_region(const SpinningPosition& position);

/// |ω_k| [rad/s] of LG03 (5.35), the spin at which stability changes; none in Regions I and III.
std::optional<double> critical_spin(const SpinningPosition& position);

}  // namespace contensou
