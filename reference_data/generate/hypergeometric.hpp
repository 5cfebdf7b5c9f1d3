#pragma once

#include "quantities.hpp"

namespace reference {

/// First route, the one that is stored: Gauss's ₂F₁.
/// With σ ∝ (1 − ρ²/R²)ⁿ and A = (n+1) B(3/2, n+1):
///
///   u <= 1:  f = A ₂F₁(−½, −3/2−n; 1; u²)           u > 1:  f/u  = ₂F₁(−½, −½; 2+n; u⁻²)
///          ξ/u = A(3/2+n) ₂F₁(½, −½−n; 2; u²)                ξ    = ₂F₁(½, −½; 2+n; u⁻²)
///            η = A ₂F₁(½, −3/2−n; 1; u²)                   u η    = ₂F₁(½, ½; 3+n; u⁻²)/(2(2+n))
///          f'' = A(3/2+n) ₂F₁(3/2, −½−n; 2; u²)          u³ f''   = ₂F₁(3/2, ½; 3+n; u⁻²)/(2(2+n))
///
/// `n` is exact. 0 <= u < ∞.
Scaled by_hypergeometric(const Ball& n, const Argument& at);

/// f for u <= 1, f/u for u > 1, from its own ₂F₁ (not from ξ and η, so that Euler's f = uξ + η is a check;
/// the one exception is u <= 1 with exponents above 500).
Ball potential_by_hypergeometric(const Ball& n, const Argument& at);

/// ₂F₁(a, b; c; z) for large c by its power series with a proven remainder. b <= 1, c > a + 1, 0 <= z <= 1.
Ball gauss_large_c(const Ball& a, const Ball& b, const Ball& c, const Ball& z);

/// ∫_0^1 p^{a-1} (1-p)^{c-a-1} (1 - m p)^{ν} dp / B(a, c-a) = ₂F₁(a, −ν; c; m)
/// for large ν m, where the power series cancels hopelessly: Watson's expansion
/// with a proven remainder. 0 < m <= 1, ν m > 100; a, c − a each ½ or 3/2.
Ball gauss_large_nu(const Ball& a, const Ball& nu, const Ball& c, const Ball& m);

}  // namespace reference
