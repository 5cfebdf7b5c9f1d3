#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// What solve_automatic keeps from one problem to the next, so that it need not allocate.
struct AutomaticMemory {};

/// The method SolverMethod::automatic. Called by ContactSolver::solve, which has checked problem
/// and options: `problem` is valid, b is not zero, `impulse` has the right size and is finite.
SolverReport solve_automatic(const ContactProblem& problem, Eigen::VectorXd& impulse,
                             const SolverOptions& options, AutomaticMemory& memory);

}  // namespace contensou
