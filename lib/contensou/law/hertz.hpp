#pragma once

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// The exact law of the Hertz pressure, σ = 3λ_N/(2πR²) √(1 − ρ²/R²) (which the paper calls parabolic): LG03
/// (3.14), (3.17), (3.18), evaluated without their cancellation. Φ is C³ across u = 1. Accuracy of ξ, η and
/// Φ: at most 4 ulp for every pair of doubles; largest found among 2 million random arguments, most of them
/// about the seams u = 3/4, 1, 4/3: 3.5. Second derivatives: at most 1e-14, found 4 ulp. See also the
/// accuracy table of the report.
struct HertzLaw {
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const;  ///< {1, 3π/16}
};

}  // namespace contensou
