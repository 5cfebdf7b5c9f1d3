#include "hypergeometric.hpp"

namespace reference {

namespace {

Ball gauss(const Ball& a, const Ball& b, const Ball& c, const Ball& z) {
  Ball r(std::max(b.bits(), z.bits()));
  arb_hypgeom_2f1(r.raw(), a.raw(), b.raw(), c.raw(), z.raw(), 0, r.bits());
  return r;
}

/// The exponent from which Arb's own ₂F₁ needs too many terms
/// or too many bits (of the stored tables: 1000 and 1e6).
constexpr double large_exponent = 500;

double midpoint(const Ball& x) { return arf_get_d(arb_midref(x.raw()), ARF_RND_NEAR); }

/// |x| <= radius becomes part of the ball.
void widen(Ball& value, const Ball& radius) { arb_add_error(value.raw(), radius.raw()); }

/// ₂F₁(a, −ν; c; m) by whichever of the two expansions suits. Arb's own is used wherever it converges in
/// reasonable time; large exponents need the other.
Ball gauss_power(double a, const Ball& nu, double c, const Ball& m) {
  const long bits = nu.bits();
  constexpr double large_product = 400;  // e^{-400/2} = 2^-288: the neglected end of the integral
  if (midpoint(nu) > large_exponent && midpoint(nu) * midpoint(m) > large_product) {
    return gauss_large_nu(Ball(a, bits), nu, Ball(c, bits), m);
  }
  return gauss(Ball(a, bits), 0.0 - nu, Ball(c, bits), m);
}

/// ₂F₁(a, b; c; z) of u > 1.
Ball gauss_outer(double a, double b, const Ball& c, const Ball& z) {
  const Ball first(a, z.bits());
  const Ball second(b, z.bits());
  return midpoint(c) > large_exponent ? gauss_large_c(first, second, c, z) : gauss(first, second, c, z);
}

}  // namespace

// With t_k the terms, all of one sign for k >= 1: as b <= 1 and z <= 1, t_{K+j} <= t_K (a+K)_j/(c+K)_j, and
// Gauss's sum ₂F₁(a+K, 1; c+K; 1) = (c+K−1)/(c−a−1) bounds the rest.
Ball gauss_large_c(const Ball& a, const Ball& b, const Ball& c, const Ball& z) {
  const long bits = z.bits();
  Ball sum(0.0, bits);
  Ball term(1.0, bits);
  constexpr int terms = 60;
  for (int k = 0; k < terms; ++k) {
    sum = sum + term;
    const double j = k;
    term = term * (a + j) * (b + j) / ((c + j) * (j + 1)) * z;
  }
  Ball rest = term * (c + (terms - 1.0)) / (c - a - 1.0);
  arb_abs(rest.raw(), rest.raw());
  widen(sum, rest);
  return sum;
}

// With x = p and b = c − a the integrand is x^{a−1} (1−x)^{b−1} (1−mx)^ν. Expand
// (1−x)^{b−1} = Σ c_k x^k with c_k = (1−b)_k/k!; here b−1 = ±½. For K >= 1 the remainder
// Σ_{k>=K} c_k x^k is at most x^K (1−x)^{−1/2} in magnitude: for b = ½ the c_k are
// positive and decrease, so Σ c_{K+j} x^j <= Σ c_j x^j; for b = 3/2, Σ_{k>=1} |c_k| = 1.
//
// Each term is integrated over x in [0, 1/m] instead of [0, 1], which gives m^{−a−k} B(a+k, ν+1). With s = mx
// that adds m^{−a−k} ∫_m^1 s^{a+k−1} (1−s)^ν ds, whose integrand falls at least like e^{−λ(s−m)}, λ = ν −
// (k+½)/m, since a <= 3/2: at most (1−m)^ν/(νm − k − ½), provided νm exceeds the number of terms.
//
// The remainder: on [0, ½], (1−x)^{−1/2} <= √2, so at most √2 m^{−a−K} B(a+K, ν+1); on [½, 1], (1−mx)^ν <=
// (1−m/2)^ν and ∫_{1/2}^1 x^{a+K−1} (1−x)^{−1/2} dx <= √2 < 2.
Ball gauss_large_nu(const Ball& a, const Ball& nu, const Ball& c, const Ball& m) {
  const long bits = m.bits();
  const Ball b = c - a;
  const Ball root_two = sqrt(Ball(2.0, bits));
  const Ball end = pow(1.0 - m, nu);

  Ball sum(0.0, bits);
  Ball coefficient(1.0, bits);
  constexpr int terms = 60;
  Ball scale = pow(m, 0.0 - a);  // m^{−a−k}
  Ball moment = beta(a, nu + 1.0);
  for (int k = 0; k < terms; ++k) {
    Ball term = coefficient * scale * moment;
    sum = sum + term;
    Ball excess = coefficient * end / (nu * m - (k + 0.5));
    arb_abs(excess.raw(), excess.raw());
    widen(sum, excess);
    coefficient = coefficient * ((k + 1.0) - b) / (k + 1.0);
    scale = scale / m;
    moment = moment * (a + static_cast<double>(k)) / (a + nu + (k + 1.0));  // B(x+1, y) = B(x, y) x/(x+y)
  }
  widen(sum, root_two * scale * moment);
  widen(sum, 2.0 * pow(1.0 - m / 2.0, nu));
  return sum / beta(a, b);
}

Ball potential_by_hypergeometric(const Ball& n, const Argument& at) {
  const long bits = at.u.bits();
  if (at.inner) {
    if (midpoint(n) > large_exponent) {
      // Its first parameter, −½, has no Euler integral to expand: f = uξ + η, which then checks nothing.
      const Scaled parts = by_hypergeometric(n, at);
      return at.u * at.u * parts.force + parts.torque;
    }
    const Ball amplitude = (n + 1.0) * beta(Ball(1.5, bits), n + 1.0);
    return amplitude * gauss(Ball(-0.5, bits), -1.5 - n, Ball(1.0, bits), at.m);
  }
  return gauss_outer(-0.5, -0.5, n + 2.0, at.m);
}

Scaled by_hypergeometric(const Ball& n, const Argument& at) {
  const long bits = at.u.bits();
  if (at.inner) {
    const Ball amplitude = (n + 1.0) * beta(Ball(1.5, bits), n + 1.0);
    const Ball slope = amplitude * (n + 1.5);
    return {slope * gauss_power(0.5, n + 0.5, 2.0, at.m), amplitude * gauss_power(0.5, n + 1.5, 1.0, at.m),
            slope * gauss_power(1.5, n + 0.5, 2.0, at.m)};
  }
  const Ball tail = 0.5 / (n + 2.0);
  return {gauss_outer(0.5, -0.5, n + 2.0, at.m), tail * gauss_outer(0.5, 0.5, n + 3.0, at.m),
          tail * gauss_outer(1.5, 0.5, n + 3.0, at.m)};
}

}  // namespace reference
