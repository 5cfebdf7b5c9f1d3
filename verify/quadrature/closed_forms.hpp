#pragma once

#include "reduced_integrals.hpp"

namespace verify {

/// A formula's value together with a bound on its relative
/// rounding error, derived from its terms, not from a run.
struct Bounded {
  double value;
  double bound;
};

/// The uniform law in complete elliptic integrals as a textbook has it, K and E from GSL. With k = u, m = u²
/// for u <= 1 and k = 1/u, m = 1/u² for u > 1 (integrate (2.2) over ρ by parts; ξ = f′, η = f − u f′):
///
///   u <= 1:  f  = 4/(9π) [(7 + m) E − 4(1 − m) K]         u > 1:  f  = 4u/(9πm) [(1 + 7m) E − (1 − m)(1 +
///   3m) K]
///            ξ  = 4/(3πu) [(1 + m) E − (1 − m) K]                 ξ  = 4/(3πm) [(1 + m) E − (1 − m) K]
///            η  = 4/(9π) [(4 − 2m) E − (1 − m) K]                 η  = 4u/(9πm) [(4m − 2) E + (1 − m)(2 −
///            3m) K] f″ = 4/(3πm) [(1 − m) K − (1 − 2m) E]                f″ = 4u/(3π) [(2 − m) E − 2(1 − m)
///            K]
///
/// Bound: 16 roundings of 2^-52 on either term (K and E of GSL are good to a few, polynomials and m add the
/// rest), summed in absolute value over the result. It grows like u⁻² for ξ, f″ (u → 0), u² for f, ξ and u⁴
/// for η, f″ (u → ∞). In addition, for 1 − m <= √2^-52 GSL 2.7 takes E from a polynomial of Abramowitz &
/// Stegun (17.3.35) whose linear and logarithmic coefficients are off by 1.05e-4 and 1.7e-5, so that E is off
/// by up to 3e-12, not its stated few 2^-52.
Bounded textbook_uniform(Quantity quantity, double u, double result);

/// The Hertz law in elementary functions to the letter of the paper: (3.14), (3.17), (3.18); f″ is not
/// printed (NaN). Bound for u > 1: 16 roundings on either term, and in addition those of 1/u and u² as arcsin
/// and the root amplify them near u = 1 and as the powers of u amplify them for large u, over the result.
Bounded printed_hertz(Quantity quantity, double u, double result);
/// That bound alone, for another implementation of the same printed formulas.
double printed_hertz_bound(Quantity quantity, double u, double result);

}  // namespace verify
