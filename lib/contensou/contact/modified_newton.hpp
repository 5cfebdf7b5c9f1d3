#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// What solve_modified_newton keeps from one problem to the next, so that it need not allocate.
struct ModifiedNewtonMemory {};

/// The method SolverMethod::modified_newton. Called by ContactSolver::solve, which has checked problem
/// and options: `problem` is valid, b is not zero, `impulse` has the right size and is finite.
SolverReport solve_modified_newton(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                   const SolverOptions& options, ModifiedNewtonMemory& memory);

}  // namespace contensou
