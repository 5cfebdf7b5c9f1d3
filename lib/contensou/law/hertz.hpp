#pragma once

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// The exact law of the Hertz pressure, σ = 3λ_N/(2πR²) √(1 − ρ²/R²) (which the paper calls parabolic): LG03
/// (3.14), (3.17), (3.18), evaluated without their cancellation. Φ is C³ across u = 1. Accuracy: see the
/// accuracy table of the report; at most 4 ulp for every pair of doubles.
struct HertzLaw {
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const;  ///< {1, 3π/16}
};

}  // namespace contensou
