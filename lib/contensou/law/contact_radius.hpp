#pragma once

namespace contensou {

/// One of the two bodies of a Hertz contact, LG03 (3.2), (3.3).
struct ElasticBody {
  double radius;   ///< ρ_i [m]: > 0, +∞ for a plane, < 0 (finite) for a hollow (concave) surface
  double modulus;  ///< E_i [Pa] > 0, +∞ for a rigid body
  double poisson;  ///< ν_i in (-1, 0.5]
};

/// E* [Pa], LG03 (3.3): 1/E* = (1 − ν_1²)/E_1 + (1 − ν_2²)/E_2. +∞ if both are rigid.
/// Throws std::invalid_argument, naming the value, for a
/// modulus or Poisson's ratio outside its range. A few ulp.
double effective_modulus(const ElasticBody& a, const ElasticBody& b);

/// ρ* [m], LG03 (3.2): 1/ρ* = 1/ρ_1 + 1/ρ_2. Throws std::invalid_argument for a radius that is none, and
/// where the bodies conform (1/ρ* <= 0: two planes, a ball in a hollow of its own or a smaller radius). A few
/// ulp, also for a ball in a hollow that is hardly larger.
double relative_radius(const ElasticBody& a, const ElasticBody& b);

/// R [m], LG03 (3.2): R = (3 ρ* λ_N / (4 E*))^{1/3}, λ_N >= 0 finite [N]. Zero without load or with two rigid
/// bodies. Throws std::invalid_argument for anything outside the ranges above. A few ulp.
///
/// The paper holds that for hard bodies this radius is extremely small and takes a constant R_0 in its place,
/// for roughness and waviness; nothing here decides that for you.
double hertz_contact_radius(const ElasticBody& a, const ElasticBody& b, double lambda_n);

}  // namespace contensou
