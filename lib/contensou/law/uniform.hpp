#pragma once

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// The exact law of a uniform pressure, σ = λ_N/(πR²): LG03 (2.1), (2.2) without truncation, in complete
/// elliptic integrals. Across u = 1 Φ is C², ξ and η are C¹; their next derivatives diverge there like a
/// logarithm. Accuracy of ξ, η and Φ: at most 4 ulp for every pair of doubles; largest found among 2 million
/// random arguments, most of them about the seams u = 3/4, 1, 4/3: 3.3. Second derivatives: at most 1e-14,
/// found 10 ulp. See also the accuracy table of the report.
struct UniformLaw {
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return {1.0, 2.0 / 3.0}; }
};

}  // namespace contensou
