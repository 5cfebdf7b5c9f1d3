#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"

namespace verify::consistency {

/// One solution, and how far it is from exact: V = max |b|; `defect` = Λ − Π(Λ − rγ), all contacts.
struct Solution {
  Eigen::VectorXd impulse;
  Eigen::VectorXd velocity;
  Eigen::VectorXd step;    ///< r_i of each row
  Eigen::VectorXd defect;  ///< the residual's vector [N s]
  double residual;
  bool at_rounding;  ///< doubles have no better impulses
  double speed;      ///< V
};

/// Solves with the default method to 1e-12, as far as `most_iterations` (0: its own limit) allow. Not solved
/// to 1e-10: residual says so.
Solution solve(const contensou::ContactProblem& problem, int most_iterations = 0);

/// Λ_F·γ_F of each contact beyond zero, and its distance from −Φ(γ_F), relative to V times
/// μΛ_N + |Λ_F| + (1 + μ)r|γ_F|: the largest over the contacts. Φ is the law's, not the ball's.
struct Power {
  double created;
  double apart_from_potential;
  int slipping;  ///< contacts on the border with |γ_F| > 1e-8 V
};
Power frictional_power(const contensou::ContactProblem& problem, const Solution& s);

/// ½Λ·(γ⁺ + γ⁻), the kinetic energy that the impact adds, relative to V Σ(|Λ_i| + r_i|γ_i|).
double energy_gained(const Solution& s, const Eigen::VectorXd& velocity_before);

/// The problem with its groups, and the contacts of each, in reverse order; `rows` says where each of the
/// new rows was.
contensou::ContactProblem reversed(const contensou::ContactProblem& problem, std::vector<Eigen::Index>& rows);

}  // namespace verify::consistency
