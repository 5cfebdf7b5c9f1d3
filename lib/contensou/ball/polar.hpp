#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou::detail {

/// A vector of the tangent plane by its length and direction, at any finite size.
struct Polar {
  double mantissa;  ///< the length is mantissa·2^exponent
  int exponent;     ///< 0 but at the ends of the range of doubles
  double e1, e2;    ///< unit vector; (1, 0) where the length is zero

  /// The length; up to √2 too small at the very end of the range, where it is the largest double.
  double length() const { return grown(mantissa); }
  /// A size in units of 2^exponent, and back, kept finite.
  double shrunk(double size) const { return exponent == 0 ? size : std::ldexp(size, -exponent); }
  double grown(double scaled) const {
    if (exponent == 0) return scaled;
    return std::min(std::ldexp(scaled, exponent), std::numeric_limits<double>::max());
  }
};

/// The same where the squares are not normal numbers. Throws std::domain_error in the name of `domain` for a
/// vector that is not finite.
Polar polar_at_ends(double x1, double x2, const char* domain);

inline Polar polar(double x1, double x2, const char* domain) {
  // Between these the square of the larger component is as accurate as normal doubles are.
  constexpr double smallest = 0x1p-900;
  constexpr double largest = 0x1p1000;
  const double square = x1 * x1 + x2 * x2;
  if (!(square > smallest && square < largest)) return polar_at_ends(x1, x2, domain);
  const double t = std::sqrt(square);
  return {t, 0, x1 / t, x2 / t};
}

[[noreturn]] void not_finite(const char* domain);
/// Throws std::invalid_argument in the name of `domain` unless size is finite and >= 0.
void require_size(double size, const char* domain);

}  // namespace contensou::detail
