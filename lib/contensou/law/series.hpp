#pragma once

#include <vector>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// The Taylor series of the law of σ ∝ (1 − ρ²/R²)ⁿ
/// about u = 0 (used for u <= 1) and about u = ∞ (used for u > 1),
///   f = Φ/(μλ_N|ω|R) = Σ inner[k] u^(2k)  and  f = Σ outer[k] u^(1−2k),  k = 0 … terms − 1,
/// the two hypergeometric series A ₂F₁(−½, −3/2−n; 1; u²) and u ₂F₁(−½, −½; 2+n; u⁻²). ξ = f' and η = f − u
/// f' are taken of the cut sum term by term, so that each side has a potential; as in the paper the two sides
/// do not quite meet at u = 1. Four terms of n = 0 are LG03 (2.8), (2.9), (2.13), (2.14).
///
/// Where n + 3/2 is a whole number (Hertz: n = ½) the inner series ends by itself after n + 5/2 terms and is
/// exact from there on; further coefficients are zero.
///
/// Accuracy: coefficient k carries at most 5k roundings, the sums (Horner's rule) a few ulp of their largest
/// term; the error that counts is that of cutting. One term alone gives ξ = 0 inside and η = 0 outside.
class SeriesLaw {
 public:
  static constexpr int most_terms = 1000;
  /// Finite n > -1, 1 <= terms <= most_terms; throws std::invalid_argument otherwise, and where a coefficient
  /// would exceed 1e290 (n in the thousands and beyond, many terms).
  SeriesLaw(double n, int terms);

  /// Throw std::domain_error as every law does (friction_law.hpp).
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  /// {1, A}: what the series gives at u = ∞ and u = 0, however few its terms.
  Extent extent() const;

  /// Coefficients of f = Φ/(μλ_N|ω|R): inner[k] of u^(2k), outer[k] of u^(1-2k).
  const std::vector<double>& inner() const { return inner_; }
  const std::vector<double>& outer() const { return outer_; }

 private:
  std::vector<double> inner_;
  std::vector<double> outer_;
};

/// LG03 (2.8), (2.9), (2.13), (2.14) to the letter: uniform pressure, the coefficients as the paper prints
/// them, without the O(·) terms; u <= 1 and u > 1 as there. Φ = v ξ + s η is then (2.8) and (2.9) to the
/// letter, too. The curvature is the derivative of (2.13). Evaluated to a few ulp of what is printed; the cut
/// itself costs most at u = 1, where the inner ξ is 1.3 % too large and the inner η 3.4 % too small.
struct PrintedUniformLaw {
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return {1.0, 2.0 / 3.0}; }
};

/// LG03 (3.14), (3.17), (3.18) to the letter: Hertz pressure in elementary functions of u = v/s, evaluated as
/// printed, with arcsin(1/u) and √(u² − 1), and therefore with the digits they lose for u > 1: for ξ terms of
/// size u² cancel to leave 1, for η terms of size u³ to leave 1/(5u), so that the relative errors grow like
/// u² ε and u⁴ ε with ε = 1e-16 (measured in the accuracy table). Nothing is left of η past u = 1e4, of ξ
/// past u = 1e8; from there on the values are finite nonsense of either sign. The curvature is the derivative
/// of (3.17), evaluated in the same manner.
///
/// The one deviation from the letter: for u > 1e77, where u⁴ leaves the range of
/// doubles and the letter would be ∞ − ∞, and at s = 0, where u is infinite, the
/// limit u → ∞ of the printed formula is returned (ξ = 1, η = 0, u³ f'' = 1/5).
struct PrintedHertzLaw {
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const;
};

}  // namespace contensou
