#include "hypergeometric.hpp"

#include <gsl/gsl_sf_gamma.h>
#include <gsl/gsl_sf_hyperg.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace verify {

GaussForm gauss_form(Quantity quantity, double n, double u) {
  const double eta_max = (n + 1) * gsl_sf_beta(1.5, n + 1);
  const double slope = eta_max * (1.5 + n);
  const double tail = 1 / (2 * (2 + n));
  const bool inner = u <= 1;
  const double w = 1 / u;
  const double inner_gap = (1 - u) * (1 + u);
  const double outer_gap = (u - 1) * (u + 1) * w * w;
  switch (quantity) {
    case Quantity::potential:
      if (inner) return {eta_max, -0.5, -1.5 - n, 1, u * u, inner_gap, 0};
      return {u, -0.5, -0.5, 2 + n, w * w, outer_gap, 0};
    case Quantity::force:
      if (inner) return {slope * u, 0.5, -0.5 - n, 2, u * u, inner_gap, 1};
      return {1, 0.5, -0.5, 2 + n, w * w, outer_gap, 0};
    case Quantity::torque:
      if (inner) return {eta_max, 0.5, -1.5 - n, 1, u * u, inner_gap, 0};
      return {tail * w, 0.5, 0.5, 3 + n, w * w, outer_gap, 1};
    case Quantity::curvature:
      if (inner) return {slope, 1.5, -0.5 - n, 2, u * u, inner_gap, 1};
      return {tail * w * w * w, 1.5, 0.5, 3 + n, w * w, outer_gap, 1};
    case Quantity::load:
      break;
  }
  return {};
}

namespace {

double ratio(double a, double b, double c, double x, int k) {
  return (a + k) * (b + k) / ((c + k) * (1 + k)) * x;
}

/// From this term on b + k > 0, so that the terms keep their sign, and q_k has come within 1/4 of its limit.
int regular_from(double a, double b, double c) {
  return 16 + static_cast<int>(std::ceil(std::abs(b) + 4 * std::abs((a - c) * (b - c))));
}

/// The bound on Σ_{k>=first} |t_k| of truncation_bound; `first` at least regular_from.
double rest_of_series(double a, double b, double c, double x, int first, double term) {
  const double q_limit = 1 + c - a - b;
  const double q = std::min(q_limit, q_limit - (a - c) * (b - c) / (c + first));
  return std::abs(term) * std::min(x < 1 ? 1 / (1 - x) : HUGE_VAL, first / (q - 1));
}

/// Γ(c) Γ(c−a−b) / (Γ(c−a) Γ(c−b)), Γ of GSL to its estimate.
Bounded gauss_theorem(double a, double b, double c) {
  double value = 1;
  double relative = 0;
  for (const auto& [argument, power] : {std::pair{c, 1}, {c - a - b, 1}, {c - a, -1}, {c - b, -1}}) {
    gsl_sf_result gamma;
    gsl_sf_gamma_e(argument, &gamma);
    value *= power > 0 ? gamma.val : 1 / gamma.val;
    relative += gamma.err / std::abs(gamma.val);
  }
  return {value, relative};
}

/// The series until the rest is negligible, a million terms at most.
Bounded series(double a, double b, double c, double x) {
  constexpr int most_terms = 1000000;
  constexpr double negligible = 1e-14;
  const int regular = regular_from(a, b, c);
  double sum = 0;
  double carry = 0;  // Kahan's: a million additions must not add up
  double term = 1;
  double rest = 0;
  for (int k = 0; k < most_terms; ++k) {
    const double corrected = term - carry;
    const double next = sum + corrected;
    carry = (next - sum) - corrected;
    sum = next;
    term *= ratio(a, b, c, x, k);
    rest = k >= regular ? rest_of_series(a, b, c, x, k + 1, term) : HUGE_VAL;
    if (rest <= negligible * std::abs(sum)) break;
  }
  return {sum, rest / std::abs(sum)};
}

/// GSL's ₂F₁ with its estimate as a relative bound.
Bounded by_gsl(double a, double b, double c, double x) {
  gsl_sf_result f;
  if (gsl_sf_hyperg_2F1_e(a, b, c, x, &f) != 0) {
    return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
  }
  return {f.val, f.err / std::abs(f.val)};
}

/// A & S 15.3.6, with 1/Γ, which has no poles, wherever Γ might.
Bounded connected(double a, double b, double c, double gap) {
  const double d = c - a - b;
  const Bounded regular = by_gsl(a, b, 1 - d, gap);
  const Bounded singular = by_gsl(c - a, c - b, 1 + d, gap);
  double of_gamma = 0;
  const auto inverse_gamma = [&of_gamma](double z) {
    gsl_sf_result r;
    gsl_sf_gammainv_e(z, &r);
    if (r.val != 0) of_gamma += r.err / std::abs(r.val);
    return r.val;
  };
  const double first = inverse_gamma(c - a) * inverse_gamma(c - b) / inverse_gamma(d) * regular.value;
  const double second =
      std::pow(gap, d) * inverse_gamma(a) * inverse_gamma(b) / inverse_gamma(-d) * singular.value;
  const double gamma_c = 1 / inverse_gamma(c);
  const double value = gamma_c * (first + second);
  const double size = gamma_c * (std::abs(first) * (regular.bound + of_gamma) +
                                 std::abs(second) * (singular.bound + of_gamma));
  return {value, size / std::abs(value)};
}

}  // namespace

Bounded hypergeometric(Quantity quantity, double n, double u) {
  const auto [factor, a, b, c, x, gap, lost] = gauss_form(quantity, n, u);
  // Γ in the factors, powers of u, and the recurrence of the
  // terms: t_k carries 4k roundings but falls at least like k^-2.
  constexpr double of_factor = 128 * 0x1p-52;
  const bool whole = std::floor(c - a - b) == c - a - b;
  const Bounded f = x < 0.5    ? by_gsl(a, b, c, x)
                    : !whole   ? connected(a, b, c, gap)
                    : gap == 0 ? gauss_theorem(a, b, c)
                               : series(a, b, c, x);
  return {factor * f.value, f.bound + of_factor};
}

double truncation_bound(Quantity quantity, double n, double u, int terms, double result) {
  const auto [factor, a, b, c, x, gap, lost] = gauss_form(quantity, n, u);
  const int kept = terms - lost;
  const int regular = std::max(kept, regular_from(a, b, c));
  double term = 1;
  double kept_size = 0;
  double rest = 0;
  for (int k = 0; k < regular; ++k) {
    (k < kept ? kept_size : rest) += std::abs(term);
    term *= ratio(a, b, c, x, k);
  }
  rest += rest_of_series(a, b, c, x, regular, term);
  // A coefficient carries at most five roundings a term, its sum and its powers of u a few more.
  const double of_rounding = (5.0 * terms + 8) * 0x1p-52 * kept_size;
  return std::abs(factor / result) * (rest + of_rounding);
}

}  // namespace verify
