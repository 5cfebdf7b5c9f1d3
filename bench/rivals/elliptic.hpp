#pragma once

#include "rivals/closed_form.hpp"

namespace rivals {

/// The uniform law in the textbook's complete elliptic integrals
/// K(k), E(k), with k = u for u <= 1 and 1/u for u > 1:
///
///   u <= 1:  f  = 4/(9π) [(7 + u²)E − 4(1 − u²)K]
///            ξ  = 4/(3πu) [(1 + u²)E − (1 − u²)K]
///            η  = 4/(9π) [(4 − 2u²)E − (1 − u²)K]
///            f″ = 4/(3πu²) [(2u² − 1)E + (1 − u²)K]
///   u > 1:   f  = 4/(9π) [u(u² + 7)E − (u² − 1)(u² + 3)K/u]
///            ξ  = 4/(3π) [(u² + 1)E − (u² − 1)K]
///            η  = 4/(9π) [u(4 − 2u²)E + (u² − 1)(2u² − 3)K/u]
///            f″ = 4/(3πu) [(2u² − 1)E − 2(u² − 1)K]
///
/// f and its derivatives follow from one another by dE/dk = (E − K)/k and dK/dk = (E − (1 − k²)K)/(k(1 −
/// k²)). One guard: at u = 1 the product of 1 − k² = 0 and K = ∞ is taken as its limit, 0.

/// K, E from boost::math::ellint_1, ellint_2 in double throughout (promote_double<false>).
extern const ClosedForm textbook_boost;
/// The same with Boost's default policy, which computes in long double where that has more digits.
extern const ClosedForm textbook_boost_promoted;
/// K, E from gsl_sf_ellint_Kcomp, gsl_sf_ellint_Ecomp
/// (GSL_PREC_DOUBLE); E(1) = 1, which GSL takes for a domain error.
extern const ClosedForm textbook_gsl;

/// The forms in D = R_D(0, 1 − m, 1)/3 and B = (1 − m) R_D(0, 1, 1 − m)/3 with Carlson's R_D from Boost
/// (promotion off), m = min(u, 1/u)², 1 − m formed without cancellation. For u > 1, η and f″ need C = (D −
/// B)/m, taken literally: there the form loses digits like u². Limits at u = 1.
extern const ClosedForm carlson_boost;

/// One ellint_1 and one ellint_2 at k, promotion off: the yardstick of the cost table.
double one_k_and_one_e(double k);

}  // namespace rivals
