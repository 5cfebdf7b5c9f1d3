#include "closed_forms.hpp"

#include <gsl/gsl_sf_ellint.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "rivals/elliptic.hpp"
#include "rivals/printed.hpp"

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

/// What a form of somebody else gives for one of the quantities, f itself for the potential.
double value_of_form(const rivals::ClosedForm& form, Quantity quantity, double u) {
  switch (quantity) {
    case Quantity::potential:
      return form.at(u).phi * std::hypot(u, 1.0);
    case Quantity::force:
      return form.at(u).xi;
    case Quantity::torque:
      return form.at(u).eta;
    case Quantity::curvature:
      return form.second(u);
    case Quantity::load:
      break;
  }
  return nan;
}

/// The textbook form is scale (of_e E + of_k (1 − m) K), m = min(u, 1/u)².
struct TextbookTerms {
  double scale;
  double of_e;
  double of_k;
};

TextbookTerms textbook_terms(Quantity quantity, double u) {
  const bool inner = u <= 1;
  const double m = inner ? u * u : 1 / (u * u);
  switch (quantity) {
    case Quantity::potential:
      if (inner) return {4 / (9 * pi), 7 + m, -4};
      return {4 * u / (9 * pi * m), 1 + 7 * m, -(1 + 3 * m)};
    case Quantity::force:
      return {inner ? 4 / (3 * pi * u) : 4 / (3 * pi * m), 1 + m, -1};
    case Quantity::torque:
      if (inner) return {4 / (9 * pi), 4 - 2 * m, -1};
      return {4 * u / (9 * pi * m), 4 * m - 2, 2 - 3 * m};
    case Quantity::curvature:
      if (inner) return {4 / (3 * pi * m), 2 * m - 1, 1};
      return {4 * u / (3 * pi), 2 - m, -2};
    case Quantity::load:
      break;
  }
  return {nan, nan, nan};
}

/// The printed Hertz form for u > 1 is scale (... arcsin(1/u) + ... √(u² − 1)); the sizes are those of the
/// two factors with every term taken positive.
struct HertzTerms {
  double scale;
  double angle_size;
  double root_size;
};

HertzTerms outer_terms(Quantity quantity, double u) {
  const double u2 = u * u;
  const double u4 = u2 * u2;
  switch (quantity) {
    case Quantity::potential:
      return {3.0 / 64, u4 + 8 * u2 + 8, u2 + 14};
    case Quantity::force:
      return {3.0 / 16 / u, u2 * (4 + u2), u2 + 2};
    case Quantity::torque:
      return {3.0 / 64, 3 * u4 + 8 * u2 + 8, 3 * u2 + 6};
    default:
      return {nan, nan, nan};
  }
}

}  // namespace

Bounded textbook_uniform(Quantity quantity, double u, double result) {
  const double k = u <= 1 ? u : 1 / u;
  const double m = k * k;
  // GSL refuses k = 1, where E = 1, and K has a logarithm, so that (1 − m) K tends to zero.
  const double e = m < 1 ? gsl_sf_ellint_Ecomp(k, GSL_PREC_DOUBLE) : 1;
  const double k_rest = m < 1 ? (1 - m) * gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE) : 0;
  const TextbookTerms t = textbook_terms(quantity, u);
  const double of_terms = roundings * epsilon * (std::abs(t.of_e * e) + std::abs(t.of_k * k_rest));
  return {value_of_form(rivals::textbook_gsl, quantity, u),
          t.scale * (of_terms + std::abs(t.of_e) * error_of_gsl_e(m)) / std::abs(result)};
}

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
  if (quantity == Quantity::curvature) return {nan, nan};
  return {value_of_form(rivals::printed_hertz, quantity, u), printed_hertz_bound(quantity, u, result)};
}

}  // namespace verify
