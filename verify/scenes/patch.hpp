#pragma once

#include "../quadrature/adaptive.hpp"

namespace verify::answers {

/// Coulomb's law on every element of a round patch of radius 1 with the pressure σ = (n+1)/π (1 − ρ²)ⁿ that
/// slides with v and turns with s, u = v/s. In polar coordinates (r, θ) about the instantaneous centre of
/// rotation an element moves across its radius, whatever r; on the line at θ, half a chord c = √(1 − u²
/// sin²θ) to either side of its middle, the measure |r| dr times the sense of the motion is r dr, analytic,
/// and ∫(1 − ρ²)ⁿ along it a beta function:
///     ξ = K B(½, n+1) u ∫ cos²θ c^(2n+1) dθ,   η = K B(3/2, n+1) ∫ c^(2n+3) dθ,   K = (n+1)/π,
/// over |θ| <= π/2 for u <= 1, over |sin θ| <= 1/u else; there with u sin θ = sin φ
///     ξ = K B(½, n+1) ∫ Δ cos^(2n+2)φ dφ,   η = K B(3/2, n+1)/u ∫ cos^(2n+4)φ/Δ dφ,   Δ = √(1 − sin²φ/u²).
/// All integrands are positive. By adaptive quadrature, relative 1e-13.
class Patch {
 public:
  struct Friction {
    double xi;   ///< ‖λ_T‖/(μλ_N)
    double eta;  ///< |λ_τ|/(μλ_N)
  };

  /// n >= 0: 0 uniform, 1/2 Hertz, 1 the paraboloid.
  explicit Patch(double n);

  double n() const { return n_; }
  /// v, s >= 0, not both zero.
  Friction at(double v, double s) const;

  double torque_at_rest() const;  ///< η(0) = (n+1) B(3/2, n+1)
  double slope_at_rest() const;   ///< ξ'(0) = (3/2 + n) η(0)

 private:
  Friction turning(double u) const;  ///< u <= 1
  Friction sliding(double k) const;  ///< k = 1/u < 1

  double n_;
  double force_, torque_;  ///< 2K times the beta functions
  mutable Adaptive rule_;
};

}  // namespace verify::answers
