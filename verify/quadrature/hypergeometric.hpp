#pragma once

#include "closed_forms.hpp"
#include "reduced_integrals.hpp"

namespace verify {

/// One side of the law of σ ∝ (1 − ρ²)ⁿ: factor · ₂F₁(a, b; c; x).
struct GaussForm {
  double factor;
  double a;
  double b;
  double c;
  double x;
  double gap;  ///< 1 − x, to full relative accuracy
  /// How many terms of this series a sum of `terms` terms of the potential leaves: one less where its
  /// constant drops out under the derivative.
  int lost_terms;
};

/// Potential f, force ξ = f′, torque η = f − u f′, curvature f″. With A = (n+1) B(3/2, n+1):
///   u <= 1 (x = u²):                             u > 1 (x = u⁻²):
///   f  = A ₂F₁(−½, −3/2−n; 1; x)                 f  = u ₂F₁(−½, −½; 2+n; x)
///   ξ  = A (3/2+n) u ₂F₁(½, −½−n; 2; x)          ξ  = ₂F₁(½, −½; 2+n; x)
///   η  = A ₂F₁(½, −3/2−n; 1; x)                  η  = ₂F₁(½, ½; 3+n; x) / (2(2+n)u)
///   f″ = A (3/2+n) ₂F₁(3/2, −½−n; 2; x)          f″ = ₂F₁(3/2, ½; 3+n; x) / (2(2+n)u³)
GaussForm gauss_form(Quantity quantity, double n, double u);

/// Its value, with a bound on its relative error made of GSL's error estimates. GSL's ₂F₁ is called for
/// arguments below 1/2 only, where it sums the series. Above, the connection formula (Abramowitz &
/// Stegun 15.3.6) leads back there; where that has a pole, for a whole c − a − b (uniform pressure, n = 1),
/// the series itself is summed, by Gauss's theorem at x = 1.
///
/// GSL 2.7 left alone would be off by tens of percent in the latter case without
/// saying so (savannah.gnu.org, GSL bug 54998), and it takes x closer to 1 than
/// 2e-13 for 1, which costs f″ half its digits where that has a root (n < 0).
Bounded hypergeometric(Quantity quantity, double n, double u);

/// A bound, relative to `result`, on what cutting the paper's Taylor series after `terms` terms of Φ leaves
/// out, plus the rounding of the terms kept.
///
/// The ratio of consecutive terms of ₂F₁ is x (1 − q_k/(k+1)) with q_k = 1 + c − a − b − (a−c)(b−c)/(c+k),
/// monotone in k. Where all q_k >= q > 1 from k = K on, the terms t_k keep one sign and Raabe's test bounds
/// the rest: Σ_{k>=K} |t_k| <= |t_K| min(1/(1 − x), K/(q − 1)).
double truncation_bound(Quantity quantity, double n, double u, int terms, double result);

}  // namespace verify
