#pragma once

#include <cmath>

namespace reference {

/// ξ and η of a contact that slips, in the precision of Real; u = |v|/(|ω|R).
template <class Real>
struct Slip {
  Real xi;
  Real eta;
};

/// Gauss's ₂F₁(a, b; c; z) by its series, for |z| at most a half or so.
template <class Real>
Real hypergeometric(Real a, Real b, Real c, Real z) {
  using std::abs;
  Real term = 1, sum = 1;
  for (int k = 0; term != 0; ++k) {
    term *= (a + k) * (b + k) / ((c + k) * (k + 1)) * z;
    const Real next = sum + term;
    if (next == sum) break;
    sum = next;
  }
  return sum;
}

enum class Pressure { uniform, hertz };

/// Both laws over u, from v = |γ_T| and s = |γ_τ|, not both zero. σ ∝ (1 − ρ²/R²)ⁿ, n = 0 or ½:
///   u² <= ½    ₂F₁ in u²;  Hertz: a polynomial, LG03 (3.17), (3.18), u <= 1
///   u² >= 2    ₂F₁ in u⁻²
///   between    complete elliptic integrals by the arithmetic-geometric mean; Hertz: elementary functions
template <class Real>
class SlipLaw {
 public:
  explicit SlipLaw(Pressure pressure)
      : pressure_(pressure), n_(pressure == Pressure::hertz ? Real(1) / 2 : 0) {
    using std::acos;
    pi_ = acos(Real(-1));
    force_ = pressure == Pressure::hertz ? 3 * pi_ / 16 : Real(2) / 3;
  }

  Slip<Real> at(const Real& v, const Real& s) const {
    if (v <= s) {
      const Real u = v / s, z = u * u;
      if (pressure_ == Pressure::hertz) return {force_ * u * (4 - z) / 2, force_ * (1 - z + 3 * z * z / 8)};
      return 2 * z <= 1 ? inner(u, z) : elliptic_inner(u, z);
    }
    const Real w = s / v, z = w * w;
    if (2 * z <= 1) return outer(w, z);
    return pressure_ == Pressure::hertz ? elementary_outer(w, z) : elliptic_outer(w, z);
  }

 private:
  Slip<Real> inner(const Real& u, const Real& z) const {
    const Real half = Real(1) / 2;
    return {force_ * (3 * half + n_) * u * hypergeometric<Real>(half, -half - n_, 2, z),
            force_ * hypergeometric<Real>(half, -3 * half - n_, 1, z)};
  }

  Slip<Real> outer(const Real& w, const Real& z) const {
    const Real half = Real(1) / 2;
    return {hypergeometric<Real>(half, -half, 2 + n_, z),
            w * hypergeometric<Real>(half, half, 3 + n_, z) / (2 * (2 + n_))};
  }

  // f'' = (3/16)[(4 − 3u²) arcsin(1/u) + (3 − 2/u²)√(u² − 1)], integrated: ξ(u), then η from f = uξ + η.
  Slip<Real> elementary_outer(const Real& w, const Real& z) const {
    using std::asin;
    using std::sqrt;
    const Real u = 1 / w, u2 = 1 / z, root = sqrt((1 - w) * (1 + w)) * u, angle = asin(w);
    return {3 * (u * (4 - u2) * angle + (2 + u2) * root / u) / 16,
            3 * ((8 - 8 * u2 + 3 * u2 * u2) * angle + (6 - 3 * u2) * root) / 64};
  }

  struct Elliptic {
    Real k, e;
  };
  // K and E of parameter m by the arithmetic-geometric mean: E/K = 1 − Σ 2^{j−1} c_j².
  Elliptic elliptic(const Real& m) const {
    using std::sqrt;
    Real a = 1, b = sqrt(1 - m), sum = m / 2, weight = 1;
    for (;;) {
      const Real c = (a - b) / 2;
      const Real term = weight * c * c;
      const Real middle = (a + b) / 2;
      b = sqrt(a * b);
      a = middle;
      if (sum + term == sum) break;
      sum += term;
      weight *= 2;
    }
    const Real k = pi_ / (2 * a);
    return {k, k * (1 - sum)};
  }

  // ξ/u = 4/(3π)[2B + (1−m)D], η = 4/(9π)[(3−m)B + (1−m)(3−2m)D], D = (K−E)/m, B = K − D.
  Slip<Real> elliptic_inner(const Real& u, const Real& m) const {
    if (m == 1) return {4 * 2 / (3 * pi_), 4 * 2 / (9 * pi_)};
    const Elliptic f = elliptic(m);
    const Real d = (f.k - f.e) / m, b = f.k - d;
    return {4 * u * (2 * b + (1 - m) * d) / (3 * pi_),
            4 * ((3 - m) * b + (1 - m) * (3 - 2 * m) * d) / (9 * pi_)};
  }

  // ξ = 4/(3π)[2B + (1−m)D], uη = 4/(9π)[2B + (1−m)C], C = (D − B)/m.
  Slip<Real> elliptic_outer(const Real& w, const Real& m) const {
    const Elliptic f = elliptic(m);
    const Real d = (f.k - f.e) / m, b = f.k - d, c = (d - b) / m;
    return {4 * (2 * b + (1 - m) * d) / (3 * pi_), 4 * w * (2 * b + (1 - m) * c) / (9 * pi_)};
  }

  Pressure pressure_;
  Real n_, pi_, force_;
};

}  // namespace reference
