#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

inline constexpr double inf = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr double smallest = std::numeric_limits<double>::denorm_min();

/// Doubles between a and b, for the same sign; huge for NaN. The measure "so many bits apart".
inline std::uint64_t ulp_distance(double a, double b) {
  if (a == b) return 0;
  if (std::isnan(a) || std::isnan(b) || std::signbit(a) != std::signbit(b))
    return std::numeric_limits<std::uint64_t>::max();
  const auto x = std::bit_cast<std::int64_t>(a);
  const auto y = std::bit_cast<std::int64_t>(b);
  return static_cast<std::uint64_t>(x > y ? x - y : y - x);
}

/// The size of a unit in the last place of |x|, for finite x.
inline double ulp_of(double x) {
  const double up = std::nextafter(std::abs(x), std::numeric_limits<double>::infinity());
  return std::isinf(up) ? std::ldexp(1.0, 971) : up - std::abs(x);
}
