#include "contensou/ball/polar.hpp"

#include <stdexcept>
#include <string>

namespace contensou::detail {

Polar polar_at_ends(double x1, double x2, const char* domain) {
  if (!(std::isfinite(x1) && std::isfinite(x2))) not_finite(domain);
  if (x1 == 0 && x2 == 0) return {0, 0, 1, 0};
  int exponent = 0;
  std::frexp(std::max(std::abs(x1), std::abs(x2)), &exponent);
  const double y1 = std::ldexp(x1, -exponent);
  const double y2 = std::ldexp(x2, -exponent);
  const double t = std::sqrt(y1 * y1 + y2 * y2);
  return {t, exponent, y1 / t, y2 / t};
}

void not_finite(const char* domain) {
  throw std::domain_error(std::string(domain) + ": a force or velocity is not finite");
}

void require_size(double size, const char* domain) {
  if (size >= 0 && std::isfinite(size)) return;
  throw std::invalid_argument(std::string(domain) + ": its size mu*lambda_N must be a finite number >= 0");
}

}  // namespace contensou::detail
