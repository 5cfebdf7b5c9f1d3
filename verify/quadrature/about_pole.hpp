#pragma once

#include "pressure.hpp"
#include "reduced_integrals.hpp"

namespace verify {

/// The definition LG03 (2.1) in polar coordinates (r, θ) about the pole w = 0, (3.1),
/// where |w| = |ω r| (3.5), as in (3.6) and (3.7) with what is misprinted there put
/// right: the measure is |r| dr (r⁻ < 0 where the pole is inside the disc) and the
/// limits (3.9) are r^± = R* cos θ ± √(R² − R*² sin² θ). In units R = ω = 1, r = q:
///   Φ = ∬ σ q² dq dθ,   ξ = ∬ σ q cos θ dq dθ,   η = ∬ σ q (q − u cos θ) dq dθ,   f″ = ∬ σ sin² θ dq dθ,
/// over full lines through the pole: θ in [0, π] for u <= 1, and twice θ in [0, θ*], sin θ* = 1/u, for u > 1.
///
/// Points symmetric about the middle of a chord carry the same pressure and are taken together; then every
/// integrand is positive. Half of the lines are integrated and doubled (mirror symmetry about e_2).
class AboutPole {
 public:
  explicit AboutPole(Pressure pressure) : pressure_(std::move(pressure)) {}
  static constexpr const char* name = "pole";

  Estimate operator()(Quantity quantity, double u);
  double worst() const { return std::max(chords_.worst(), lines_.worst()); }

 private:
  /// One line through the pole at angle θ: distance of its chord's
  /// middle from the pole and from the centre, half-length.
  struct Chord {
    double middle;  ///< u cos θ
    double offset;  ///< u sin θ
    double half;    ///< √(1 − u² sin² θ)
    double cosine;  ///< cos θ
    double sine;    ///< sin θ
  };
  double along(Quantity quantity, const Chord& chord);

  Pressure pressure_;
  Adaptive chords_{inner_tolerance};
  Adaptive lines_{outer_tolerance};
};

}  // namespace verify
