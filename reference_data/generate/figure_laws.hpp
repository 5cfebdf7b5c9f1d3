#pragma once

#include <vector>

#include "ball.hpp"

namespace reference {

/// What the reference curves of the figures are made of: laws from Gauss's ₂F₁, the plate as printed, the
/// nearest point of a plate; forces in μλ_N.
constexpr long bits = 256;

Ball exact(double x);

struct Pair {
  Ball xi;
  Ball eta;
};

/// ξ and η of σ ∝ (1 − ρ²/R²)ⁿ at v, s >= 0, not both zero; the formulas at the head of hypergeometric.hpp.
Pair law(const Ball& n, const Ball& v, const Ball& s);
Pair law(const Ball& n, double v, double s);

/// Φ/(μλ_N) at v, s, from its own ₂F₁.
Ball potential(const Ball& n, double v, double s);

/// A point of the border of LG03 (2.18), and the branch it is on.
struct Printed {
  const char* branch;
  Pair at;
};

/// A quarter of that border: 33 points a branch, evenly in ξ and then quadratically.
std::vector<Printed> printed_border();

/// The nearest point of the friction plate to (t, tau) outside, both >= 0.
Pair nearest(const Ball& n, double t, double tau);

}  // namespace reference
