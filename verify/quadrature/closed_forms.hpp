#pragma once

#include "reduced_integrals.hpp"

namespace verify {

/// A formula's value together with a bound on its relative rounding error, derived from its terms, not from a
/// run.
struct Bounded {
  double value;
  double bound;
};

/// The uniform law in complete elliptic integrals K and E of GSL as a textbook has it: rivals::textbook_gsl.
///
/// Bound: 16 roundings of 2^-52 on either term (K and E of GSL are good to a few, polynomials and m add the
/// rest), summed in absolute value over the result. It grows like u⁻² for ξ, f″ (u → 0), u² for f, ξ and u⁴
/// for η, f″ (u → ∞). In addition, for 1 − m <= √2^-52 GSL 2.7 takes E from a polynomial of Abramowitz &
/// Stegun (17.3.35) whose linear and logarithmic coefficients are off by 1.05e-4 and 1.7e-5, so that E is off
/// by up to 3e-12, not its stated few 2^-52.
Bounded textbook_uniform(Quantity quantity, double u, double result);

/// The Hertz law to the letter of the paper, (3.14), (3.17), (3.18): rivals::printed_hertz; f″ is not printed
/// (NaN).
Bounded printed_hertz(Quantity quantity, double u, double result);
/// Its bound alone, for another implementation of the same printed formulas. For u > 1: 16 roundings on
/// either term, and in addition those of 1/u and u² as arcsin and the root amplify them near u = 1 and as the
/// powers of u amplify them for large u, over the result.
double printed_hertz_bound(Quantity quantity, double u, double result);

}  // namespace verify
