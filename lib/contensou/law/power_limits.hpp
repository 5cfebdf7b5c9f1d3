#pragma once

namespace contensou {

/// What a law of σ ∝ (1 − ρ²/R²)ⁿ is at its two ends, which is all that most approximations know of it.
struct PowerLimits {
  double eta_max;  ///< η at u = 0, A = (n+1) B(3/2, n+1): 2/3 uniform, 3π/16 Hertz
  double slope;    ///< f''(0) = dξ/du at u = 0, A (3/2 + n): 1 uniform, 3π/8 Hertz
  double tail;     ///< lim u η for u → ∞, 1/(2 (2 + n)): 1/4 uniform, 1/5 Hertz
};

/// Valid for finite n > -1; throws std::invalid_argument otherwise. Relative error below 1e-15 for n <= 1e6;
/// the values of the uniform and the Hertz law are correctly rounded.
PowerLimits power_limits(double n);

}  // namespace contensou
