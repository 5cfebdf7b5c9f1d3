#pragma once

#include <cmath>
#include <concepts>

namespace contensou {

/// Friction of a contact patch that slides and spins, in units of μλ_N (dimensionless, both >= 0).
/// The signs and directions are those of friction: λ_T = -ξ μλ_N γ_T/‖γ_T‖, λ_τ = -η μλ_N sgn γ_τ.
struct Friction {
  double xi;   ///< ξ = ‖λ_T‖/(μλ_N), LG03 (3.20)
  double eta;  ///< η = |λ_τ|/(μλ_N) = |τ_N|/(μλ_N R), LG03 (3.20)
};

/// Second derivatives of Φ/(μλ_N) with respect to v = ‖γ_T‖ and s = |γ_τ| [s/m].
struct Curvature {
  double vv;
  double vs;
  double ss;
};

/// Semi-axes of the friction ball in units of μλ_N: the
/// largest ξ (without spin), the largest η (without sliding).
struct Extent {
  double xi;
  double eta;
};

/// A friction law, exact or approximate: the friction as a function of the sliding speed v = ‖γ_T‖ >= 0 and
/// the spin speed s = |γ_τ| = |ω|R >= 0, both in m/s, at most one of them infinite.
///
/// Laws that have no scale of their own depend on u = v/s only (LG03 (2.8)); taking v and s apart keeps 1 - u
/// exact near u = 1, and 1/u exact for large u.
///
/// At v = s = 0 the friction is not a number but the whole set B_F; `at` and
/// `curvature` then throw std::domain_error, as they do for NaN and negative
/// arguments. `friction_force` (force.hpp) returns the set instead.
template <class L>
concept FrictionLaw = requires(const L& law, double v, double s) {
  { law.at(v, s) } -> std::same_as<Friction>;
  { law.curvature(v, s) } -> std::same_as<Curvature>;
  { law.extent() } -> std::same_as<Extent>;
};

/// A law with a velocity scale of its own: not homogeneous of degree one, it brings its potential with it.
template <class L>
concept HasOwnScale = requires(const L& law, double v, double s) {
  { law.potential(v, s) } -> std::same_as<double>;
};

/// Φ/(μλ_N) [m/s]: the velocity pseudo-potential, LG03 (2.1). For a law that is homogeneous of degree one it
/// is the dissipated power v ξ + s η (Euler); a law with a scale of its own brings its potential with it.
template <FrictionLaw L>
double potential(const L& law, double v, double s) {
  if constexpr (HasOwnScale<L>) {
    return law.potential(v, s);
  } else {
    const auto [xi, eta] = law.at(v, s);
    return v * xi + s * eta;
  }
}

/// One row of the reduced law: phi = Φ/(μλ_N √(v² + (ωR)²)), finite for every u in [0, ∞].
struct Reduced {
  double phi;
  double xi;
  double eta;
};

/// The law at u = v/|ωR| in [0, ∞]; u = 0 is pure spin, u = ∞ pure sliding. A law with a velocity scale of
/// its own is taken at √(v² + (ωR)²) = 1 m/s. Throws std::domain_error for NaN or negative u.
template <FrictionLaw L>
Reduced reduced(const L& law, double u) {
  if constexpr (HasOwnScale<L>) {
    const double length = std::hypot(u, 1.0);
    const double v = std::isinf(u) ? 1.0 : u / length;
    const double s = 1.0 / length;
    const auto [xi, eta] = law.at(v, s);
    return {law.potential(v, s), xi, eta};
  } else {
    const auto [xi, eta] = law.at(u, 1.0);
    if (u <= 1) return {(u * xi + eta) / std::sqrt(1 + u * u), xi, eta};
    const double w = 1 / u;
    return {(xi + eta * w) / std::sqrt(1 + w * w), xi, eta};
  }
}

}  // namespace contensou
