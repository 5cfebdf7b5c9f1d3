#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"

namespace random_contact {

/// How well Λ satisfies the contact laws as they are written, LG03 (4.8), for each contact
///     γ_N >= 0, Λ_N >= 0, γ_N Λ_N = 0;   Λ_F in B(μΛ_N);   −Λ_F·γ_F = μΛ_N Φ(γ_F),
/// with γ = WΛ + b in long double and the potential Φ of the law alone: no projection, no gauge, no natural
/// map. With V = max|b| and r_i = 1/‖W_ii‖ (row sums), the largest over contacts of
///     |min(γ_N, Λ_N/r)|/V,
///     distance of Λ_F from B(μΛ_N), by its support function in 256 directions and a search among them, /(r V
///     (1+μ)),
///     (Λ_F·γ_F + μΛ_N Φ(γ_F)) / (V (‖Λ_F‖ + μΛ_N + r (1 + μ)(V + ‖γ_F‖))).
/// V = 0: 0 for Λ = 0, else infinite. Infinite where any of it is NaN.
/// Impulses whose natural map has the residual ε have at most 2ε here: Λ is within ε r V of a point p at
/// which velocities within εV of γ lie in the normal cone, and μΛ_N within μ ε r V of the size p belongs to.
double inclusion_residual(const contensou::ContactProblem& problem, const Eigen::VectorXd& impulse);

/// How far one rounding of each impulse moves the natural map, measured: the largest of |WδΛ|/V over 32
/// random δΛ = ±2^-53 Λ, in long double, and of ‖δΛ_i‖/(r_i V). No doubles can be expected to do much better.
double rounding_spread(const contensou::ContactProblem& problem, const Eigen::VectorXd& impulse);

}  // namespace random_contact
