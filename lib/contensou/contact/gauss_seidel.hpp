#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// What solve_gauss_seidel keeps from one problem to the next, so that it need not allocate.
struct GaussSeidelMemory {};

/// The method SolverMethod::gauss_seidel. Called by ContactSolver::solve, which has checked problem
/// and options: `problem` is valid, b is not zero, `impulse` has the right size and is finite.
SolverReport solve_gauss_seidel(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                const SolverOptions& options, GaussSeidelMemory& memory);

}  // namespace contensou
