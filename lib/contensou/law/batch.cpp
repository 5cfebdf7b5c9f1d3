#include "contensou/law/batch.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "contensou/law/coefficients.hpp"

// Written in the compiler's vector types, eight lanes wide; on x86-64 compiled three times, and the machine
// picks at load time. A machine with narrower registers takes several for one pack.
#if defined(__x86_64__) && defined(__GNUC__)
#define CONTENSOU_VECTORISED __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define CONTENSOU_VECTORISED
#endif
#define CONTENSOU_INLINE inline __attribute__((always_inline))

namespace contensou {
namespace {

namespace c = coefficients;

constexpr std::size_t block = 256;  // values a call; a shorter rest is filled up
constexpr double seam =
    0.75;  // min(u, 1/u) above which the power series give way to the expansion about u = 1

constexpr std::size_t lanes = 8;
using Pack = double __attribute__((vector_size(8 * lanes)));
using Bits = std::uint64_t __attribute__((vector_size(8 * lanes)));
using Mask =
    std::int64_t __attribute__((vector_size(8 * lanes)));  // what comparing two packs gives: 0 or all ones

/// A block of values on its way: u in, the reduced law out.
struct Block {
  std::array<double, block> u;
  std::array<double, block> phi;
  std::array<double, block> xi;
  std::array<double, block> eta;
};

/// The same, wherever the values lie.
struct BlockPointers {
  const double* u;
  double* phi;
  double* xi;
  double* eta;
};

CONTENSOU_INLINE Pack load(const double* from) {
  Pack pack;
  std::memcpy(&pack, from, sizeof pack);
  return pack;
}

CONTENSOU_INLINE void store(double* to, Pack pack) { std::memcpy(to, &pack, sizeof pack); }

CONTENSOU_INLINE Pack root(Pack x) {
  for (std::size_t i = 0; i < lanes; ++i) x[i] = std::sqrt(x[i]);
  return x;
}

/// Σ c_k t^k over every second k from `first`, in powers of t² = t2, by Horner's rule, unrolled.
template <std::size_t first, std::size_t N, std::size_t... K>
CONTENSOU_INLINE Pack every_second(const std::array<double, N>& coefficient, Pack t2,
                                   std::index_sequence<K...>) {
  constexpr std::size_t last = first + 2 * sizeof...(K);
  Pack value = Pack{} + coefficient[last];
  ((value = value * t2 + coefficient[last - 2 * (K + 1)]), ...);
  return value;
}

/// Σ c_k t^k as an even and an odd chain, which halves the time that one result waits for the next.
template <std::size_t N>
CONTENSOU_INLINE Pack polynomial(const std::array<double, N>& coefficient, Pack t) {
  const Pack t2 = t * t;
  const Pack odd = every_second<1>(coefficient, t2, std::make_index_sequence<(N - 2) / 2>());
  const Pack even = every_second<2>(coefficient, t2, std::make_index_sequence<(N - 3) / 2>());
  return coefficient[0] + t * (odd + t * even);
}

/// ln y for y in (0, 1): exponent and mantissa apart, then the series of artanh. 0 and subnormals give a
/// finite number, which is enough where ln y comes with a factor y². Absolute error below 1e-15.
CONTENSOU_INLINE Pack logarithm(Pack y) {
  constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcd;  // bits of √½
  constexpr std::uint64_t mantissa = 0x000fffffffffffff;
  const Bits bits = std::bit_cast<Bits>(y) - root_half;
  // the exponent as a double, by way of the bits of 2^52 +
  // exponent (not every machine converts integers in packs)
  const Pack exponent = std::bit_cast<Pack>(((bits >> 52) ^ 0x800) | 0x4330000000000000) - (0x1p52 + 0x800);
  const Pack reduced = std::bit_cast<Pack>((bits & mantissa) + root_half);
  const Pack s = (reduced - 1) / (reduced + 1);
  constexpr std::array<double, 11> artanh{1,        1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9, 1.0 / 11,
                                          1.0 / 13, 1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21};
  return exponent * std::numbers::ln2 + 2 * s * polynomial(artanh, s * s);
}

/// Lane by lane a where the mask is set, else b; in bits, since compilers take `mask ? a : b` apart when a
/// mask serves more than once.
CONTENSOU_INLINE Pack select(Mask mask, Pack a, Pack b) {
  return std::bit_cast<Pack>((mask & std::bit_cast<Mask>(a)) | (~mask & std::bit_cast<Mask>(b)));
}

/// u, with NaN for what is none.
CONTENSOU_INLINE Pack load_ratio(const double* from) {
  const Pack u = load(from);
  return select(u >= 0, u, Pack{} + std::numeric_limits<double>::quiet_NaN());
}

/// (1 + m)^(−1/2) for 0 <= m <= 1 by Newton's iteration, which here costs less than a root and a division.
CONTENSOU_INLINE Pack inverse_root(Pack m) {
  Pack y = polynomial(c::inverse_root, m);
  for (int step = 0; step < 2; ++step) y = y + y * (0.5 - (0.5 + 0.5 * m) * (y * y));
  return y;
}

/// Stores ξ, η and phi = (u ξ + η)/√(1 + u²), the latter without overflow for u → ∞; x = min(u, 1/u).
CONTENSOU_INLINE void store_reduced(const BlockPointers& b, std::size_t i, Mask inner, Pack x, Pack xi,
                                    Pack eta) {
  const Pack sum = select(inner, x * xi + eta, xi + x * eta);
  store(b.phi + i, sum * inverse_root(x * x));
  store(b.xi + i, xi);
  store(b.eta + i, eta);
}

/// Is any lane of a comparison true? Folded by halves.
CONTENSOU_INLINE bool any(Mask mask) {
  const auto four =
      __builtin_shufflevector(mask, mask, 0, 1, 2, 3) | __builtin_shufflevector(mask, mask, 4, 5, 6, 7);
  const auto two = __builtin_shufflevector(four, four, 0, 1) | __builtin_shufflevector(four, four, 2, 3);
  return (two[0] | two[1]) != 0;
}

/// What a law gives for one pack.
struct Forces {
  Pack xi;
  Pack eta;
};

/// Uniform pressure. Far from the seam one pair F, T of power series in m = min(u, 1/u)² serves both sides:
///   u <= 1: ξ = u F(m), η = (2/3)(1 − m) F(m) + m T(m);   u > 1: ξ = F(m), η = T(m)/u.
/// Near it both sides are P(y) + y² ln|y| Q(y) in y = (u − 1)/(u + 1).
struct Uniform {
  static CONTENSOU_INLINE Mask is_near(Mask /*inner*/, Pack x) { return x > seam; }

  static CONTENSOU_INLINE Forces far(Mask inner, Pack /*u*/, Pack x) {
    const Pack m = x * x;
    const Pack force = polynomial(c::uniform_force, m);
    const Pack torque = polynomial(c::uniform_outer_torque, m);
    return {select(inner, x * force, force),
            select(inner, 2.0 / 3 * (1 - m) * force + m * torque, x * torque)};
  }

  static CONTENSOU_INLINE Forces near(Pack u) {
    const Pack y = (u - 1) / (u + 1);
    const Pack size = std::bit_cast<Pack>(std::bit_cast<Bits>(y) & ~(std::uint64_t{1} << 63));
    const Pack y2_log = y * y * logarithm(size);
    return {polynomial(c::uniform_near_force, y) + y2_log * polynomial(c::uniform_near_force_log, y),
            polynomial(c::uniform_near_torque, y) + y2_log * polynomial(c::uniform_near_torque_log, y)};
  }
};

/// Hertz pressure. Inside polynomials in 1 − u²; outside, far from the seam, power series in 1/u², near it
/// polynomials in √y, y = (u − 1)/(u + 1).
struct Hertz {
  static CONTENSOU_INLINE Mask is_near(Mask inner, Pack x) { return select(inner, Pack{}, x) > seam; }

  static CONTENSOU_INLINE Pack inner_force(Pack u, Pack mc) { return u * (12 * k + 4 * k * mc); }
  static CONTENSOU_INLINE Pack inner_torque(Pack mc) { return 3 * k + mc * (2 * k + 3 * k * mc); }

  static CONTENSOU_INLINE Forces far(Mask inner, Pack u, Pack x) {
    const Pack m = x * x;
    const Pack mc = (1 - u) * (1 + u);  // of no use outside, and not used there
    return {select(inner, inner_force(x, mc), polynomial(c::hertz_outer_force, m)),
            select(inner, inner_torque(mc), x * polynomial(c::hertz_outer_torque, m))};
  }

  static CONTENSOU_INLINE Forces near(Pack u) {
    const Pack z = root((u - 1) / (u + 1));
    return {polynomial(c::hertz_near_force, z), polynomial(c::hertz_near_torque, z)};
  }

  static constexpr double k = 3 * std::numbers::pi / 128;
};

/// One block: every pack by the form that holds far from the seam. The values
/// near it are collected meanwhile, done again together by the other form, and
/// put in their places: a value pays for being near, its neighbours do not.
template <class Law>
CONTENSOU_INLINE void evaluate_block(const BlockPointers& b) {
  std::array<std::uint32_t, block> place;
  Block close;
  std::size_t found = 0;
  for (std::size_t i = 0; i < block; i += lanes) {
    const Pack u = load_ratio(b.u + i);
    const Mask inner = u <= 1;
    const Pack x = select(inner, u, 1 / u);
    const auto [xi, eta] = Law::far(inner, u, x);
    const Mask near = Law::is_near(inner, x);
    if (any(near)) {
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        place[found] = static_cast<std::uint32_t>(i + lane);
        close.u[found] = b.u[i + lane];  // now: a result stored over it would be the end of it
        found += near[lane] != 0;
      }
    }
    store_reduced(b, i, inner, x, xi, eta);
  }
  if (found == 0) return;

  for (std::size_t j = found; j % lanes != 0; ++j) close.u[j] = 1;
  const BlockPointers at{close.u.data(), close.phi.data(), close.xi.data(), close.eta.data()};
  for (std::size_t i = 0; i < found; i += lanes) {
    const Pack u = load(at.u + i);
    const Mask inner = u <= 1;
    const auto [xi, eta] = Law::near(u);
    store_reduced(at, i, inner, select(inner, u, 1 / u), xi, eta);
  }
  for (std::size_t j = 0; j < found; ++j) {
    b.phi[place[j]] = close.phi[j];
    b.xi[place[j]] = close.xi[j];
    b.eta[place[j]] = close.eta[j];
  }
}

CONTENSOU_VECTORISED
void uniform_block(BlockPointers b) { evaluate_block<Uniform>(b); }

CONTENSOU_VECTORISED
void hertz_block(BlockPointers b) { evaluate_block<Hertz>(b); }

void evaluate(void (*law)(BlockPointers), std::span<const double> u, ReducedBatch out) {
  if (out.phi.size() != u.size() || out.xi.size() != u.size() || out.eta.size() != u.size()) {
    throw std::invalid_argument("batch: phi, xi and eta must be as long as u");
  }
  std::size_t start = 0;
  for (; start + block <= u.size(); start += block) {
    law({&u[start], &out.phi[start], &out.xi[start], &out.eta[start]});
  }
  if (start == u.size()) return;
  Block rest{};
  std::copy(u.begin() + static_cast<std::ptrdiff_t>(start), u.end(), rest.u.begin());
  law({rest.u.data(), rest.phi.data(), rest.xi.data(), rest.eta.data()});
  for (std::size_t i = 0; start + i < u.size(); ++i) {
    out.phi[start + i] = rest.phi[i];
    out.xi[start + i] = rest.xi[i];
    out.eta[start + i] = rest.eta[i];
  }
}

}  // namespace

void reduced_uniform(std::span<const double> u, ReducedBatch out) { evaluate(uniform_block, u, out); }

void reduced_hertz(std::span<const double> u, ReducedBatch out) { evaluate(hertz_block, u, out); }

}  // namespace contensou
