#pragma once

#include <Eigen/Core>

#include "checks.hpp"

namespace verify::consistency {

/// Where W is positive definite and friction small, Λ is unique and depends continuously on b.
///
/// For two solutions Λ, Λ' of b, b': (Λ_N − Λ'_N)(γ_N − γ'_N) <= 0, and since −Λ_F·γ_F = μΛ_N φ(γ_F) while
/// −Λ_F·γ'_F <= μΛ_N φ(γ'_F), with φ the potential of a ball of size 1,
///     (Λ_F − Λ'_F)·(γ_F − γ'_F) <= −μ(Λ_N − Λ'_N)(φ(γ_F) − φ(γ'_F)) <= μ a |ΔΛ_N| |Δγ_F|,
/// a the largest distance of the ball from its centre. With rows scaled, Λ = SΛ~, W~ = SWS of condition κ,
/// and q = μ a √κ < 1 it follows with Δγ~ = W~ΔΛ~ + Δb~ that (1 − q)|ΔΛ~|_W <= (1 + μa)|Δb~|/√λ_min, so that
///     |Δγ~| <= ((1 + μa) √κ/(1 − q) + 1) |Δb~|.
/// S has one number for the rows N, T of a contact and one that is not smaller for τ, which makes the ball
/// no larger. A computed Λ with Λ − Π = e is near P = Π, which solves exactly for b~ = b + We − e/r.
struct Uniqueness {
  bool proven;            ///< q <= 0.9
  Eigen::VectorXd scale;  ///< S
  double amplification;   ///< of |Δb~| into |Δγ~|
};
Uniqueness uniqueness(const contensou::ContactProblem& problem);

/// S(We − e/r), and what rounding does to γ: the |Δb~| that stands for the solution's errors.
double disturbance(const contensou::ContactProblem& problem, const Uniqueness& u, const Solution& s);

}  // namespace verify::consistency
