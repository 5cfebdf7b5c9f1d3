#pragma once

#include <vector>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// The Taylor series of the law of σ ∝ (1 − ρ²/R²)ⁿ about u = 0 (used for u <= 1) and about u = ∞ (used for u > 1),
/// cut after `terms` terms of Φ on either side; ξ and η are the derivatives of that sum, term by term. As in the paper
/// the two sides do not quite meet at u = 1. Does not exist where the inner series ends (n + 3/2 a whole number): there
/// further terms are zero.
class SeriesLaw {
 public:
  /// -1 < n, 1 <= terms <= 1000; throws std::invalid_argument otherwise.
  SeriesLaw(double n, int terms);

  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const;

  /// Coefficients of f = Φ/(μλ_N|ω|R): inner[k] of u^(2k), outer[k] of u^(1-2k).
  const std::vector<double>& inner() const { return inner_; }
  const std::vector<double>& outer() const { return outer_; }

 private:
  std::vector<double> inner_;
  std::vector<double> outer_;
};

/// LG03 (2.8), (2.9), (2.13), (2.14) to the letter: uniform pressure, the coefficients as the paper prints them.
struct PrintedUniformLaw {
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return {1.0, 2.0 / 3.0}; }
};

/// LG03 (3.14), (3.17), (3.18) to the letter: Hertz pressure in elementary functions, evaluated as printed, with the
/// digits they lose for u > 1 (measured in the accuracy table).
struct PrintedHertzLaw {
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const;
};

}  // namespace contensou
