#pragma once

#include <cmath>

namespace contensou {

/// What linear resistance does within a step, exact for a constant force: from v' = f − cv with a = cΔt,
///     v(Δt) = v e^{−a} + f Δt φ₁(a),    ∫v dt = v Δt φ₁(a) + f Δt² φ₂(a),
///     φ₁ = (1 − e^{−a})/a,  φ₂ = (1 − φ₁)/a.
/// To rounding for every a >= 0.
struct Decay {
  double left = 1;          ///< e^{−a}
  double first = 1;         ///< φ₁(a)
  double second = 1.0 / 2;  ///< φ₂(a)

  Decay() = default;
  explicit Decay(double a) {
    if (a == 0) return;
    left = std::exp(-a);
    first = -std::expm1(-a) / a;
    // Below, where 1 − φ₁ cancels, the series: the next term is below 1e-17.
    constexpr double small = 2e-3;
    second = a < small ? 1.0 / 2 - a * (1.0 / 6 - a * (1.0 / 24 - a * (1.0 / 120 - a * (1.0 / 720))))
                       : (1 - first) / a;
  }
};

}  // namespace contensou
