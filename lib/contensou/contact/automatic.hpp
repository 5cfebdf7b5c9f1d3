#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/covering_path.hpp"
#include "contensou/contact/gauss_seidel.hpp"
#include "contensou/contact/scaled_problem.hpp"
#include "contensou/contact/semismooth_newton.hpp"

namespace contensou {

/// What solve_automatic keeps from one problem to the next, so that it need not allocate.
struct AutomaticMemory {
  ScaledProblem scaled;
  Eigen::VectorXd x, best, impulse, centre, diagonal, b;
  NewtonMemory newton;
  GaussSeidelMemory gauss_seidel;
  CoveringPathMemory path;
};

/// One contact: solve_one_contact, which has a limit of its own and heeds no other. Several, or where that
/// does not do:
///   1. Newton's method (semismooth_newton.hpp), 30 iterations;
///   2. Gauss–Seidel for 10, 30 and 90 sweeps, each followed by 1;
///   3. up to 40 proximal point steps (Rockafellar, 1976), each a better conditioned problem for 1;
///   4. up to 24 times the covering path (covering_path.hpp), each with another direction and other steps,
///      followed by Newton's method with adapted steps, and by 20 sweeps and 1 from there, every eighth by 3,
///      too.
/// The first rung that reaches the tolerance ends it; so does a residual that is rounding, once below 1e-10
/// or after four paths (`at_rounding`: impulses so large, or radii so large, that doubles have no better
/// ones). `iterations` counts those of solve_one_contact, Newton iterations, sweeps and steps of the path
/// alike; without a limit of the caller's there are some 21 000 at the very most.
///
/// The method SolverMethod::automatic. Preconditions: those of ContactSolver::solve's methods, see there.
SolverReport solve_automatic(const ContactProblem& problem, Eigen::VectorXd& impulse,
                             const SolverOptions& options, AutomaticMemory& memory);

}  // namespace contensou
