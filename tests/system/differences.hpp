#pragma once

#include <Eigen/Core>

#include "contensou/integrate/motion.hpp"

/// What any mechanical system's terms must satisfy, by differences of its own geometry. Systems and states
/// with lengths, masses and rates of order one.
namespace system_test {

/// A generic vector of numbers between ±1, none of them small or equal to another.
Eigen::VectorXd generic(Eigen::Index n, double phase);

/// Five-point derivative of f(t) at 0: for functions of order one with rates of order one the truncation is
/// h⁴/30 and the rounding 1e-16/h.
constexpr double difference_step = 1e-3;
template <class F>
auto rate(const F& f) {
  constexpr double h = difference_step;
  decltype(f(h)) sum = f(-2 * h);
  for (const double t : {-1, 1, 2}) sum += (t == 2 ? -1 : 8 * t) * f(t * h);
  return decltype(sum)(sum / (12 * h));
}
/// What such a derivative may be off, for functions up to some tens and rates up to a few.
constexpr double difference_bound = 1e-9;

/// The state after the time t (small) at constant acceleration u̇.
contensou::State moved(const contensou::MechanicalSystem& system, const contensou::State& state,
                       const Eigen::VectorXd& acceleration, double t);

/// Checks, with Catch's CHECK: M symmetric; T = uᵀMu/2; M M⁻¹h = h; M M⁻¹W = W; γ = Wᵀu + w̃ and γ_N = ġ_N;
/// the drift against the derivative of γ at u̇ = 0; the rate of T + V under forces at all contacts against
/// their power Σ(Wᵀu)·λ and that of works(); absent rows left alone; sizes of scales; a state on the manifold
/// unchanged by restore().
void check_terms(const contensou::MechanicalSystem& system, const contensou::State& state);

}  // namespace system_test
