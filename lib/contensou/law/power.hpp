#pragma once

#include "contensou/law/compiled.hpp"

namespace contensou {

/// The exact law of σ ∝ (1 − ρ²/R²)ⁿ, n > −1, by quadrature of one positive integral: the slow and sure form.
///
/// With κ = 1 − (min(v,s)/max(v,s))² every quantity is a multiple of
///   J_jp(κ) = (2/π) ∫_0^∞ sinh^{2j}z (1 + κ sinh²z)^p cosh^{−(2n+4)}z dz,
/// whose integrand is positive and analytic in |Im z| < π/2 for every κ, so that the trapezoidal rule
/// converges geometrically up to and at u = 1. It follows from LG03 (3.6) (corrected) by doing the radial
/// integral along each chord through the pole in closed form (Beta functions).
class PowerQuadrature {
 public:
  static constexpr double largest_n = 1e6;
  /// Valid for -1 < n <= largest_n; throws std::invalid_argument otherwise.
  explicit PowerQuadrature(double n);
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return {1.0, eta_scale_}; }
  double n() const { return n_; }

  /// The bounded forms at v/s = u and s/v = w in [0, 1].
  BoundedForm inner(SlipRatio u) const;
  BoundedForm outer(SlipRatio w) const;

 private:
  double n_;
  double xi_scale_;   // (n+1) B(1/2, n+1)
  double eta_scale_;  // (n+1) B(3/2, n+1)
};

/// The same law, compiled once at construction: relative error at most 1e-13 in ξ and η and in the second
/// derivatives, for every n.
class PowerLaw : public CompiledLaw {
 public:
  /// -1 < n <= 1e6; throws std::invalid_argument otherwise. Takes 10 ms for n > 1, up to
  /// 200 ms for n towards −1, where the seam u = 1 is sharpest.
  explicit PowerLaw(double n);
  explicit PowerLaw(const PowerQuadrature& law);
};

}  // namespace contensou
