#include "closed_forms.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace verify {
namespace {

using std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double epsilon = 0x1p-52;
constexpr double roundings = 16;

/// What GSL's polynomial for E close to k = 1 is off by: see the header.
double error_of_gsl_e(double m) {
  const double gap = 1 - m;
  return gap > 0 && gap <= std::sqrt(epsilon) ? gap * (1.05e-4 + 1.7e-5 * std::abs(std::log(gap))) : 0;
}

/// scale (a E + b (1 − m) K), what every one of the forms consists of, with the bound on its rounding error.
Bounded two_terms(double scale, double a, double e, double b, double k_rest, double m, double result) {
  const double of_terms = roundings * epsilon * (std::abs(a * e) + std::abs(b * k_rest));
  return {scale * (a * e + b * k_rest),
          scale * (of_terms + std::abs(a) * error_of_gsl_e(m)) / std::abs(result)};
}

}  // namespace

Bounded textbook_uniform(Quantity quantity, double u, double result) {
  const bool inner = u <= 1;
  const double k = inner ? u : 1 / u;
  const double m = k * k;
  // GSL refuses k = 1, where E = 1, and K has a logarithm, so that (1 − m) K tends to zero.
  const double e = m < 1 ? gsl_sf_ellint_Ecomp(k, GSL_PREC_DOUBLE) : 1;
  const double k_rest = m < 1 ? (1 - m) * gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE) : 0;
  const auto form = [&](double scale, double of_e, double of_k) {
    return two_terms(scale, of_e, e, of_k, k_rest, m, result);
  };
  switch (quantity) {
    case Quantity::potential:
      return inner ? form(4 / (9 * pi), 7 + m, -4) : form(4 * u / (9 * pi * m), 1 + 7 * m, -(1 + 3 * m));
    case Quantity::force:
      return form(inner ? 4 / (3 * pi * u) : 4 / (3 * pi * m), 1 + m, -1);
    case Quantity::torque:
      return inner ? form(4 / (9 * pi), 4 - 2 * m, -1) : form(4 * u / (9 * pi * m), 4 * m - 2, 2 - 3 * m);
    case Quantity::curvature:
      return inner ? form(4 / (3 * pi * m), 2 * m - 1, 1) : form(4 * u / (3 * pi), 2 - m, -2);
    case Quantity::load:
      break;
  }
  return {nan, nan};
}

namespace {

/// The printed Hertz form for u > 1 is scale (angle_factor arcsin(1/u) + root_factor √(u² − 1)).
struct HertzTerms {
  double scale;
  double angle_factor;
  double root_factor;
  double angle_size;  ///< angle_factor and root_factor with every term taken positive
  double root_size;
};

HertzTerms outer_terms(Quantity quantity, double u) {
  const double u2 = u * u;
  const double u4 = u2 * u2;
  switch (quantity) {
    case Quantity::potential:
      return {3.0 / 64, -u4 + 8 * u2 + 8, u2 + 14, u4 + 8 * u2 + 8, u2 + 14};
    case Quantity::force:
      return {3.0 / 16 / u, u2 * (4 - u2), u2 + 2, u2 * (4 + u2), u2 + 2};
    case Quantity::torque:
      return {3.0 / 64, 3 * u4 - 8 * u2 + 8, -3 * u2 + 6, 3 * u4 + 8 * u2 + 8, 3 * u2 + 6};
    default:
      return {nan, nan, nan, nan, nan};
  }
}

}  // namespace

double printed_hertz_bound(Quantity quantity, double u, double result) {
  if (u <= 1) {
    // Polynomials in u² whose terms sum to at most 19 (torque, at u = 1: 3 + 8 + 8) where they leave at
    // least 3.
    return roundings * epsilon * 19 / 3;
  }
  const HertzTerms t = outer_terms(quantity, u);
  const double root = std::sqrt((u - 1) * (u + 1));
  const double of_terms = roundings * epsilon * (t.angle_size * std::asin(1 / u) + t.root_size * root);
  // d arcsin(x) = dx/√(1 − x²) with x = 1/u; d√y = dy/(2√y) with y = u² − 1. No more than the values
  // themselves change over the last bit: both arguments are at most one rounding away, and arcsin and root
  // differ by √(2ε) from those of 1.
  const double of_arguments =
      t.angle_size * std::fmin(epsilon / root, std::sqrt(2 * epsilon)) +
      t.root_size * std::fmin(epsilon * u * u / (2 * root), std::sqrt(2 * epsilon) * u);
  return t.scale * (of_terms + of_arguments) / std::abs(result);
}

Bounded printed_hertz(Quantity quantity, double u, double result) {
  const double bound = printed_hertz_bound(quantity, u, result);
  if (u > 1) {
    const HertzTerms t = outer_terms(quantity, u);
    return {t.scale * (t.angle_factor * std::asin(1 / u) + t.root_factor * std::sqrt(u * u - 1)), bound};
  }
  const double u2 = u * u;
  switch (quantity) {
    case Quantity::potential:
      return {3 * pi / 128 * (-u2 * u2 + 8 * u2 + 8), bound};
    case Quantity::force:
      return {3 * pi / 32 * u * (-u2 + 4), bound};
    case Quantity::torque:
      return {3 * pi / 128 * (3 * u2 * u2 - 8 * u2 + 8), bound};
    default:
      return {nan, nan};
  }
}

}  // namespace verify
