#include "contensou/law/power_limits.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contensou/text/number.hpp"

namespace contensou {

PowerLimits power_limits(double n) {
  if (!(n > -1) || !std::isfinite(n)) {
    throw std::invalid_argument("pressure exponent " + to_text(n) + ": expected a finite number > -1");
  }
  const double tail = 1 / (2 * (2 + n));
  if (n == 0.0) return {2.0 / 3.0, 1.0, tail};
  if (n == 0.5) return {3 * std::numbers::pi / 16, 3 * std::numbers::pi / 8, tail};
  // A = (n+1) B(3/2, n+1) = Γ(3/2) Γ(n+2)/Γ(n+5/2): the
  // ratio as one function, for each Γ overflows at n = 170.
  const double half_sqrt_pi = 1 / (2 * std::numbers::inv_sqrtpi);
  const double eta_max = half_sqrt_pi * boost::math::tgamma_delta_ratio(n + 2, 0.5);
  return {eta_max, eta_max * (1.5 + n), tail};
}

}  // namespace contensou
