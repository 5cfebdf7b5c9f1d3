#pragma once

#include "pressure.hpp"
#include "reduced_integrals.hpp"

namespace verify {

/// The definition LG03 (2.1) in polar coordinates (ρ, φ) about the centre of the disc, as in (2.2):
///   Φ = ∬ σ |w| ρ dφ dρ,      |w|² = u² + ρ² − 2uρ sin φ        (R = ω = 1, v = u),
/// and, by Coulomb's law on each element, with w = (u − ρ sin φ, ρ cos φ):
///   ξ = ∬ σ w₁/|w| dA,        η = ∬ σ (x w₂ − y w₁)/|w| dA,      f″ = ∬ σ w₂²/|w|³ dA.
///
/// The elements at ±χ and π ± χ of a ring, χ = φ − π/2, are taken together. That is the same integral, but
/// its integrand is now positive for every quantity and the small ones (ξ for u → 0, η for u → ∞) come out to
/// full relative accuracy.
class AboutCentre {
 public:
  explicit AboutCentre(Pressure pressure) : pressure_(std::move(pressure)) {}
  static constexpr const char* name = "centre";

  /// The integral at u >= 0; the estimate adds the inner tolerance to GSL's outer estimate.
  Estimate operator()(Quantity quantity, double u);

  /// Largest estimated error in units of what was asked for, of the rings and of the radial integrals.
  double worst() const { return std::max(rings_.worst(), radial_.worst()); }

 private:
  Pressure pressure_;
  Adaptive rings_{inner_tolerance};
  Adaptive radial_{outer_tolerance};
};

}  // namespace verify
