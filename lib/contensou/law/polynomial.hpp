#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace contensou {

/// Two polynomials of the same argument side by side: what
/// one costs, both cost where the machine has two lanes.
using Lanes = double __attribute__((vector_size(16)));

/// Coefficients of two polynomials interleaved, the shorter filled up with zeros.
template <std::size_t N, std::size_t M>
constexpr auto interleave(const std::array<double, N>& a, const std::array<double, M>& b) {
  std::array<std::array<double, 2>, std::max(N, M)> pairs{};
  for (std::size_t k = 0; k < N; ++k) pairs[k][0] = a[k];
  for (std::size_t k = 0; k < M; ++k) pairs[k][1] = b[k];
  return pairs;
}

namespace detail {

template <std::size_t First, std::size_t Stride, std::size_t N>
inline Lanes horner(const std::array<std::array<double, 2>, N>& c, double t) {
  constexpr std::size_t last = First + (N - 1 - First) / Stride * Stride;
  Lanes value{c[last][0], c[last][1]};
  for (std::size_t k = last; k >= First + Stride; k -= Stride) {
    value = value * t + Lanes{c[k - Stride][0], c[k - Stride][1]};
  }
  return value;
}

}  // namespace detail

/// Σ c_k t^k for both lanes. Four interleaved chains keep the latency down; the two lowest powers are added
/// last, so that where they dominate the result is good to little more than half an ulp.
template <std::size_t N>
inline Lanes evaluate(const std::array<std::array<double, 2>, N>& c, double t) {
  static_assert(N >= 8);
  const double t2 = t * t;
  const double t4 = t2 * t2;
  const Lanes p2 = detail::horner<2, 4>(c, t4);
  const Lanes p3 = detail::horner<3, 4>(c, t4);
  const Lanes p4 = detail::horner<4, 4>(c, t4);
  const Lanes p5 = detail::horner<5, 4>(c, t4);
  const Lanes rest = t2 * ((p2 + t * p3) + t2 * (p4 + t * p5));
  return Lanes{c[0][0], c[0][1]} + (t * Lanes{c[1][0], c[1][1]} + rest);
}

/// Σ c_k t^k, by Horner's rule.
template <std::size_t N>
inline double evaluate(const std::array<double, N>& c, double t) {
  double value = c[N - 1];
  for (std::size_t k = N - 1; k-- > 0;) value = value * t + c[k];
  return value;
}

}  // namespace contensou
