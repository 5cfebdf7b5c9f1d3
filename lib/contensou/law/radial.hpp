#pragma once

#include <functional>
#include <vector>

#include "contensou/law/compiled.hpp"

namespace contensou {

/// A radially symmetric pressure on 0 <= ρ/R <= 1; only its shape counts, the law divides by its integral.
struct RadialPressure {
  std::function<double(double)> sigma;  ///< σ(ρ/R) >= 0, finite inside, not zero everywhere
  std::vector<double> breaks;           ///< radii ρ/R in (0, 1) where σ or one of its derivatives jumps
  bool linear = false;  ///< σ is linear between breaks: far from R*, 15 points a piece are enough
};

/// Linear interpolation of a table; `rho` strictly increasing from 0 to 1, `sigma` >= 0 and finite, the same
/// length, at least 2. Throws std::invalid_argument naming the offending entry.
RadialPressure tabulated_pressure(std::vector<double> rho, std::vector<double> sigma);

/// The law of any radially symmetric pressure: a superposition
/// of thin rings, each in complete elliptic integrals,
///   ξ_ring = (2/π) a B(a²), η_ring = (2/π) E(a²)          for a = v/|ωρ| <= 1,
///   ξ_ring = (2/π) E(a⁻²),  η_ring = (2/π) a⁻¹ B(a⁻²)     for a > 1,
/// integrated over ρ by tanh-sinh quadrature between the pressure's breaks, split at ρ = R* = v/|ω|; a linear
/// pressure away from R* by Gauss's rule of 15 points. Relative accuracy about 1e-13 in ξ and η for a
/// pressure that is smooth between its breaks; where σ itself is infinite at the edge, as (1 − ρ²)^(−1/2) is,
/// σ(ρ) is ill-conditioned there and 1e-8 is what is left (PowerLaw does not have that problem). Some ten
/// microseconds a break and evaluation. Breaks below 1e-290 are not resolved.
class RadialLaw {
 public:
  /// Throws std::invalid_argument if the pressure is negative,
  /// not finite or zero everywhere, or a break is not in (0, 1).
  explicit RadialLaw(RadialPressure pressure);

  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return {1.0, eta_max_}; }

  /// The same law as piecewise polynomials, for use in a simulation; see CompiledLaw for the bound it states.
  /// It takes some 10^4 evaluations: below a second without breaks; a table of 100 entries takes some 2 s at
  /// 1e-6, one of 30 entries some 6 s at 1e-12.
  CompiledLaw compile(double tolerance = 1e-12) const;

 private:
  enum class Quantity { force, torque, second };
  double integral(double split, const std::function<double(double)>& integrand) const;
  double inner(SlipRatio u, Quantity quantity) const;
  double outer(SlipRatio w, Quantity quantity) const;

  RadialPressure pressure_;  // breaks sorted, with 0 and 1
  double load_ = 1;          // ∫ σ ρ dρ
  double eta_max_ = 0;
};

}  // namespace contensou
