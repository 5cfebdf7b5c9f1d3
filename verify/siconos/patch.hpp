#pragma once

#include <Eigen/Core>
#include <vector>

#include "points.hpp"
#include "rivals/siconos.hpp"

namespace verify::siconos {

/// One contact with Coulomb–Contensou friction: γ = W λ + b in the rows (N, T1, T2, τ).
struct PatchContact {
  Eigen::Matrix4d w;
  Eigen::Vector4d b;
  double mu;
};

/// What the contact with the patch cut into N points comes to.
struct PatchSolution {
  Eigen::Vector4d force;     ///< (λ_N, λ_T1, λ_T2, λ_τ)
  Eigen::Vector4d velocity;  ///< (γ_N, γ_T1, γ_T2, γ_τ)
  double error;              ///< Siconos's own measure of what it returned
  int info, iterations;
};

/// The same contact for Siconos's friction code: N + 1 Coulomb contacts. The first has no friction and the
/// true normal row, W_NN λ_N + W_NF λ_F + b_N. Point i has friction μ and for its normal row
///     u_i = W_NN (r_i − w_i λ_N) >= 0 ⊥ r_i >= 0,    so that r_i = w_i λ_N,
/// and slips with the rigid patch, u_T = γ_T + γ_τ e_z × x_i, where λ_F = Σ (r_T, x_i × r_T). The normal
/// force and its feedback through W_NF are so solved for, too; the matrix is not symmetric, which
/// Gauss–Seidel does not ask for.
rivals::SiconosProblem cut(const PatchContact& contact, const std::vector<PatchPoint>& points);

/// Solves it with the method and the tolerance, in Siconos's measure, from zero.
PatchSolution solve_cut(const PatchContact& contact, const std::vector<PatchPoint>& points,
                        const std::string& method, double tolerance, int max_iterations);

}  // namespace verify::siconos
