#include "contensou/law/series.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "contensou/law/power_limits.hpp"
#include "contensou/law/slip_ratio.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

/// Σ_{k >= first} weight(k) c[k] x^(k − first), by Horner's rule.
template <class Weight>
double weighted_sum(const std::vector<double>& c, std::size_t first, double x, const Weight& weight) {
  double sum = 0;
  for (std::size_t k = c.size(); k-- > first;) sum = sum * x + weight(2.0 * static_cast<double>(k)) * c[k];
  return sum;
}

// Derivatives of u^m for m = 2k (inner) and m = 1 − 2k (outer), as functions of 2k: the pattern is the same
// with ξ and η changing places, for w f(1/w) = Σ outer[k] w^(2k) is the potential with v and s interchanged.
constexpr auto slope = [](double m) { return m; };             // of the derivative
constexpr auto rest = [](double m) { return 1 - m; };          // of f − u f'
constexpr auto second = [](double m) { return m * (m - 1); };  // of the second derivative

}  // namespace

SeriesLaw::SeriesLaw(double n, int terms) {
  // No sum of 1000 such coefficients times 4e6, the largest factor of a second derivative, overflows.
  constexpr double largest_coefficient = 1e290;
  const double eta_max = power_limits(n).eta_max;  // refuses a bad n
  if (terms < 1 || terms > most_terms) {
    throw std::invalid_argument("series of " + std::to_string(terms) + " terms: expected 1 to " +
                                std::to_string(most_terms));
  }
  inner_.push_back(eta_max);
  outer_.push_back(1.0);
  for (int i = 0; i + 1 < terms; ++i) {
    const double k = i;
    inner_.push_back(inner_.back() * (k - 0.5) * (k - 1.5 - n) / ((k + 1) * (k + 1)));
    outer_.push_back(outer_.back() * (k - 0.5) * (k - 0.5) / ((k + 2 + n) * (k + 1)));
    if (!(std::abs(inner_.back()) <= largest_coefficient)) {
      throw std::invalid_argument("series of " + std::to_string(terms) + " terms for n = " + to_text(n) +
                                  ": the coefficients exceed 1e290, expected at most " +
                                  std::to_string(i + 1) + " terms");
    }
  }
}

Friction SeriesLaw::at(double v, double s) const {
  return friction_from(
      v, s,
      [this](SlipRatio u) {
        return BoundedForm{weighted_sum(inner_, 1, u.x * u.x, slope),
                           weighted_sum(inner_, 0, u.x * u.x, rest), 0};
      },
      [this](SlipRatio w) {
        return BoundedForm{weighted_sum(outer_, 0, w.x * w.x, rest),
                           weighted_sum(outer_, 1, w.x * w.x, slope), 0};
      });
}

Curvature SeriesLaw::curvature(double v, double s) const {
  return curvature_from(
      v, s, [this](SlipRatio u) { return weighted_sum(inner_, 1, u.x * u.x, second); },
      [this](SlipRatio w) { return weighted_sum(outer_, 1, w.x * w.x, second); });
}

Extent SeriesLaw::extent() const { return {outer_.front(), inner_.front()}; }

Friction PrintedUniformLaw::at(double v, double s) const {
  return friction_from(
      v, s,
      [](SlipRatio u) {
        const double x = u.x * u.x;
        return BoundedForm{1 + x * (-1.0 / 8 + x * (-1.0 / 64)),                             // (2.13), u <= 1
                           2.0 / 3 + x * (-1.0 / 2 + x * (3.0 / 32 + x * (5.0 / 384))), 0};  // (2.14)
      },
      [](SlipRatio w) {
        const double x = w.x * w.x;
        return BoundedForm{1 + x * (-1.0 / 8 + x * (-1.0 / 64 + x * (-5.0 / 1024))),  // (2.13), u > 1
                           1.0 / 4 + x * (1.0 / 48 + x * (3.0 / 512)), 0};            // (2.14)
      });
}

Curvature PrintedUniformLaw::curvature(double v, double s) const {
  return curvature_from(
      v, s,
      [](SlipRatio u) {
        const double x = u.x * u.x;
        return 1 + x * (-3.0 / 8 + x * (-5.0 / 64));
      },
      [](SlipRatio w) {
        const double x = w.x * w.x;
        return 1.0 / 4 + x * (1.0 / 16 + x * (15.0 / 512));
      });
}

namespace {

// u⁴ is a double up to 1.1e77.
constexpr double letter_ends = 1e77;

}  // namespace

Friction PrintedHertzLaw::at(double v, double s) const {
  require_slip(v, s);
  const double u = v / s;
  if (u > letter_ends) return {1.0, 0.0};
  using std::numbers::pi;
  if (u <= 1) {
    return {3 * pi / 32 * u * (-(u * u) + 4), 3 * pi / 128 * (3 * u * u * u * u - 8 * u * u + 8)};
  }
  const double root = std::sqrt(u * u - 1);
  const double angle = std::asin(1 / u);
  return {3.0 / 16 / u * (u * u * (4 - u * u) * angle + (u * u + 2) * root),
          3.0 / 64 * ((3 * u * u * u * u - 8 * u * u + 8) * angle + (-3 * u * u + 6) * root)};
}

Curvature PrintedHertzLaw::curvature(double v, double s) const {
  const double u = v / s;
  if (u > letter_ends) {
    return curvature_from(
        v, s, [](SlipRatio) { return 0.0; }, [](SlipRatio) { return 1.0 / 5; });
  }
  require_slip(v, s);
  using std::numbers::pi;
  const double f2 =
      u <= 1 ? 3 * pi / 32 * (-3 * u * u + 4)
             : 3.0 / 16 * ((-3 * u * u + 4) * std::asin(1 / u) + (3 - 2 / (u * u)) * std::sqrt(u * u - 1));
  return {f2 / s, -u * f2 / s, u * u * f2 / s};
}

Extent PrintedHertzLaw::extent() const { return {1.0, 3 * std::numbers::pi / 16}; }

}  // namespace contensou
