#pragma once

#include <array>
#include <string>

#include "ball.hpp"

namespace reference {

/// Significant digits of the tables.
constexpr int digits = 34;

/// phi, xi, eta, f2 as they are written.
using Entries = std::array<std::string, 4>;

/// What the checks of a table came to. Radii are relative, as powers of two.
struct Proof {
  int rows = 0;
  int closed = 0;  ///< rows checked against elliptic or elementary closed forms
  int chords = 0;  ///< rows checked against integration along chords, LG03 (3.6)
  int rings = 0;   ///< rows checked against integration along rings, LG03 (2.2)
  double widest_stored = -1e9;
  double widest_closed = -1e9;
  double widest_chord = -1e9;
  double widest_ring = -1e9;
  long most_bits = 0;  ///< working precision the stored route needed
};

/// Which of the slow checks to make.
struct Checks {
  bool chords;
  bool rings;
};

/// The table's entries for the exact double u >= 0, finite, and pressure exponent n: ₂F₁, at a precision
/// raised until the rounding of every entry is settled. Throws std::runtime_error if it does not settle or if
/// any check fails: always Euler's f = u ξ + η with f from its own ₂F₁, always the closed forms for n = 0, ½,
/// the integrals as asked.
Entries evaluate(double n, double u, Checks checks, Proof& proof);

/// The entries at u = ∞: 1, 1, 0, 1/(2(2+n)).
Entries at_infinity(double n);

}  // namespace reference
