#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// What solve_gauss_seidel keeps from one problem to the next, so that it need not allocate.
struct GaussSeidelMemory {
  Eigen::VectorXd step;      ///< r_i of the natural map
  Eigen::VectorXd velocity;  ///< γ = WΛ + b, kept up to date contact by contact
  Eigen::VectorXd best;      ///< impulses of the smallest residual seen
};

/// Projected block Gauss–Seidel: contact after contact, each solved exactly for the impulses the others have
/// (one_contact.hpp), warm-started by its own last impulse, γ brought up to date at once. One iteration is a
/// sweep over all contacts. Contacts without friction take one row and run no friction code.
///
/// The residual is looked at when a sweep changes γ by little enough that it could be below the tolerance,
/// and every 16 sweeps. Not every problem is solved: with several contacts nothing is proven but for small μ,
/// and large mass ratios make it slow, with and without friction. Going only part of the way or beyond (0.3
/// to 1.5) solves no more problems, so there is no such option. At most 5000 sweeps unless limited otherwise;
/// `stalled` after 640 sweeps that bring no residual lower by a tenth. Of all impulses looked at, the best
/// are returned.
///
/// The method SolverMethod::gauss_seidel. Preconditions: those of ContactSolver::solve's methods, see
/// there.
SolverReport solve_gauss_seidel(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                const SolverOptions& options, GaussSeidelMemory& memory);

}  // namespace contensou
