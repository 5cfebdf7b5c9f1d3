#pragma once

#include <functional>
#include <vector>

#include "contensou/law/compiled.hpp"

namespace contensou {

/// A radially symmetric pressure on 0 <= ρ/R <= 1; only its shape counts, the law divides by its integral.
struct RadialPressure {
  std::function<double(double)> sigma;  ///< σ(ρ/R) >= 0, finite, not zero everywhere
  std::vector<double> breaks;           ///< radii ρ/R in (0, 1) where σ or its slope jumps
};

/// Linear interpolation of a table; `rho` strictly increasing from 0 to 1, `sigma` >= 0, the same length >= 2.
/// Throws std::invalid_argument naming the offending entry.
RadialPressure tabulated_pressure(std::vector<double> rho, std::vector<double> sigma);

/// The law of any radially symmetric pressure: a superposition of thin rings, each in complete elliptic integrals,
/// integrated over ρ by tanh-sinh quadrature split at ρ = R* = v/|ω| and at the pressure's breaks.
/// Relative accuracy about 1e-13 for a pressure that is smooth between its breaks.
class RadialLaw {
 public:
  /// Throws std::invalid_argument if the pressure is negative, not finite or zero everywhere.
  explicit RadialLaw(RadialPressure pressure);
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return {1.0, eta_max_}; }

  /// The same law as piecewise polynomials, for use in a simulation; see CompiledLaw for the bound it states.
  CompiledLaw compile(double tolerance = 1e-12) const;

 private:
  RadialPressure pressure_;
  double total_;  // ∫ σ ρ dρ
  double eta_max_;
};

}  // namespace contensou
