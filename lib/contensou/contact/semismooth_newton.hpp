#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// What solve_semismooth_newton keeps from one problem to the next, so that it need not allocate.
struct SemismoothNewtonMemory {};

/// The method SolverMethod::semismooth_newton. Called by ContactSolver::solve, which has checked problem
/// and options: `problem` is valid, b is not zero, `impulse` has the right size and is finite.
SolverReport solve_semismooth_newton(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                     const SolverOptions& options, SemismoothNewtonMemory& memory);

}  // namespace contensou
