#include "oracle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace verify::ball {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real unknown = std::numeric_limits<Real>::quiet_NaN();

/// Gauss's ₂F₁(a, b; c; x) for |x| <= ½, by its terms.
Real gauss(Real a, Real b, Real c, Real x) {
  constexpr Real negligible = 1e-21L;
  Real term = 1;
  Real sum = 1;
  for (Real k = 0; std::abs(term) > negligible * std::abs(sum); ++k) {
    term *= (a + k) * (b + k) / ((c + k) * (k + 1)) * x;
    sum += term;
  }
  return sum;
}

/// ξ and η at x = min(u, 1/u), u <= 1 where `inner`.
struct Force {
  Real xi;
  Real eta;
};

Force by_series(Real n, Real eta_max, bool inner, Real x) {
  const Real m = x * x;
  if (inner) {
    return {eta_max * (1.5L + n) * x * gauss(0.5L, -0.5L - n, 2, m), eta_max * gauss(0.5L, -1.5L - n, 1, m)};
  }
  return {gauss(0.5L, -0.5L, 2 + n, m), x / (2 * (2 + n)) * gauss(0.5L, 0.5L, 3 + n, m)};
}

/// Uniform pressure, m = x² > ½: complete elliptic integrals by the arithmetic-geometric mean.
Force uniform_near_seam(bool inner, Real x) {
  const Real m = x * x;
  const Real mc = (1 - x) * (1 + x);
  Real big_b = 1;
  Real mc_d = 0;
  if (mc > 0) {
    Real a = 1;
    Real b = std::sqrt(mc);
    Real weight = 0.5L;
    Real sum = m / 2;               // Σ 2^{k−1} c_k²
    constexpr Real close = 1e-11L;  // the next step squares it
    while (std::abs(a - b) > close * a) {
      const Real c = (a - b) / 2;
      const Real mean = (a + b) / 2;
      b = std::sqrt(a * b);
      a = mean;
      weight *= 2;
      sum += weight * c * c;
    }
    const Real big_k = pi / (a + b);
    const Real big_d = big_k * sum / m;
    mc_d = mc * big_d;
    big_b = big_k - big_d;
  }
  if (inner) {
    const Real mc_d_times = mc_d * (3 - 2 * m);
    return {4 * x / (3 * pi) * (2 * big_b + mc_d), 4 / (9 * pi) * ((3 - m) * big_b + mc_d_times)};
  }
  const Real mc_c = (mc_d - mc * big_b) / m;
  return {4 / (3 * pi) * (2 * big_b + mc_d), 4 * x / (9 * pi) * (2 * big_b + mc_c)};
}

/// Hertz pressure, x² > ½: LG03 (3.17), (3.18).
Force hertz_near_seam(bool inner, Real x) {
  if (inner) {
    const Real q = x * x;
    return {3 * pi / 32 * x * (4 - q), 3 * pi / 128 * (8 + q * (3 * q - 8))};
  }
  const Real u = 1 / x;
  const Real q = u * u;
  const Real root = std::sqrt((1 - x) * (1 + x)) / x;
  const Real angle = std::asin(x);
  return {3 / (16 * u) * (q * (4 - q) * angle + (q + 2) * root),
          3.0L / 64 * ((3 * q * q - 8 * q + 8) * angle + (6 - 3 * q) * root)};
}

Force force(Real n, Real eta_max, bool inner, Real x) {
  constexpr Real largest_inner_term = 2;
  if (x * x <= 0.5L) {
    if (inner && (n + 1.5L) * x * x > largest_inner_term) return {unknown, unknown};
    return by_series(n, eta_max, inner, x);
  }
  if (n == 0) return uniform_near_seam(inner, x);
  if (n == 0.5L) return hertz_near_seam(inner, x);
  return {unknown, unknown};
}

/// Distance along the normal, and what being beside the border point takes off the border.
Real off_border(Pair q, Pair n, Force border) {
  const Real along = (q.t - border.xi) * n.t + (q.tau - border.eta) * n.tau;
  const Real beside = (q.t - border.xi) * n.tau - (q.tau - border.eta) * n.t;
  return std::abs(along) + beside * beside;
}

}  // namespace

Oracle exact_oracle(std::vector<Share> shares) {
  return [shares = std::move(shares)](Pair q, Pair normal) -> Real {
    const bool inner = normal.t <= normal.tau;
    const Real x = inner ? normal.t / normal.tau : normal.tau / normal.t;
    Force border{0, 0};
    for (const auto& [n, eta_max, weight] : shares) {
      const Force f = force(n, eta_max, inner, x);
      border.xi += weight * f.xi;
      border.eta += weight * f.eta;
    }
    return off_border(q, normal, border);
  };
}

Oracle ellipsoid_oracle(Real a, Real b) {
  return [=](Pair q, Pair n) {
    const Real h = std::hypot(a * n.t, b * n.tau);
    return off_border(q, n, {a * a * n.t / h, b * b * n.tau / h});
  };
}

Oracle rectangle_oracle(Real a, Real b) {
  return [=](Pair q, Pair n) {
    const Real outside = std::max({q.t - a, q.tau - b, Real(0)});
    return std::max(outside, std::abs(a * n.t + b * n.tau - q.t * n.t - q.tau * n.tau));
  };
}

Oracle series_oracle(contensou::PlateSeries series) {
  return [=](Pair q, Pair) {
    // A polynomial in y² without its constant, and its derivative with respect to y.
    const auto polynomial = [](const std::vector<double>& c, Real y) {
      Real value = 0;
      Real slope = 0;
      for (auto k = c.rbegin(); k != c.rend(); ++k) {
        slope = slope * y * y + value;
        value = value * y * y + *k;
      }
      return Force{value * y * y, 2 * y * (value + slope * y * y)};
    };
    const Real seam = series.seam;
    // On the border the gradient is longer than 1; well inside, where it may vanish, a distance is not asked
    // for.
    const auto length = [](Real x, Real y) { return std::max(std::hypot(x, y), Real(1)); };
    const auto inner_off = [&] {
      const Real height = series.extent.eta;
      const auto [value, slope] = polynomial(series.inner, q.t);
      return (q.tau * q.tau / (height * height) + value - 1) / length(2 * q.tau / (height * height), slope);
    };
    const auto outer_off = [&] {
      const auto [value, slope] = polynomial(series.outer, q.tau);
      return (q.t * q.t + value - 1) / length(2 * q.t, slope);
    };
    constexpr Real near_seam = 1e-13L;
    if (q.t < seam * (1 - near_seam)) return std::abs(inner_off());
    if (q.t > seam * (1 + near_seam)) return std::abs(outer_off());
    // On the step: between the two pieces' ends, or on either.
    const Real inner = inner_off();
    const Real outer = outer_off();
    if ((inner < 0) != (outer < 0)) return std::abs(q.t - seam);
    return std::min(std::abs(inner), std::abs(outer));
  };
}

}  // namespace verify::ball
