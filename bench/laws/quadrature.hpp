#pragma once

#include <gsl/gsl_integration.h>

#include <memory>

#include "contensou/law/friction_law.hpp"

namespace bench {

using Workspace = std::shared_ptr<gsl_integration_workspace>;

// Pressures are given by 2n, a whole number: 0 uniform, 1
// Hertz, so that no power needs more than one square root.

/// The definition LG03 (2.1) over the disc in polar
/// coordinates about its centre, (2.2), for σ ∝ (1 − ρ²/R²)ⁿ:
///   ξ = (n+1)/π ∫_0^1 ρ(1−ρ²)ⁿ ∫_0^{2π} (u − ρ sin φ)/w dφ dρ,      w² = u² + ρ² − 2uρ sin φ,
///   η = (n+1)/π ∫_0^1 ρ(1−ρ²)ⁿ ∫_0^{2π} ρ(ρ − u sin φ)/w dφ dρ,     Φ from Euler's theorem.
/// Adaptive Gauss–Kronrod quadrature (QAGS) in ρ, split at ρ = u where the pole lies on the disc, of adaptive
/// quadrature (QAG, 21 points) in φ; both to the absolute tolerance, ten times smaller inside.
class DefinitionQuadrature {
 public:
  DefinitionQuadrature(int twice_n, double tolerance);
  contensou::Reduced operator()(double u) const;

 private:
  int twice_n_;
  double tolerance_;
  Workspace radial_;
  Workspace angular_;
};

/// The double integral with the radial one done in closed form along each chord through the pole, LG03 (3.8)
/// to (3.11) for any n: with B₁ = B(1/2, n+1), B₃ = B(3/2, n+1), and sin θ = sin t/u for u > 1,
///   u <= 1:  ξ = (n+1)B₁ (2u/π) ∫_0^{π/2} cos²t (1 − u² sin²t)^{n+1/2} dt,
///            η = (n+1)B₃ (2/π) ∫_0^{π/2} (1 − u² sin²t)^{n+3/2} dt,
///   u > 1:   ξ = (n+1)B₁ (2/π) ∫_0^{π/2} cos^{2n+2}t √(1 − w² sin²t) dt,          w = 1/u,
///            η = (n+1)B₃ (2w/π) ∫_0^{π/2} cos^{2n+4}t /√(1 − w² sin²t) dt.
class ChordIntegrals {
 public:
  explicit ChordIntegrals(int twice_n);

  /// Φ, ξ, η with each integral over [0, π/2] done by rule(integrand).
  template <class Rule>
  contensou::Reduced at(double u, const Rule& rule) const;

 private:
  int twice_n_;
  double force_scale_;   // (n+1) B₁ 2/π
  double torque_scale_;  // (n+1) B₃ 2/π
};

/// By GSL's QAG (21 points) or QAGS to an absolute tolerance.
class ChordAdaptive {
 public:
  enum class Rule { qag, qags };
  ChordAdaptive(int twice_n, Rule rule, double tolerance);
  contensou::Reduced operator()(double u) const;

 private:
  ChordIntegrals integrals_;
  Rule rule_;
  double tolerance_;
  Workspace workspace_;
};

/// By Gauss's rule of a fixed number of points.
class ChordGauss {
 public:
  ChordGauss(int twice_n, std::size_t points);
  contensou::Reduced operator()(double u) const;

 private:
  ChordIntegrals integrals_;
  std::shared_ptr<gsl_integration_glfixed_table> table_;
};

}  // namespace bench
