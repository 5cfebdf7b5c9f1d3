#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/scaled_problem.hpp"

namespace contensou {

/// What newton_iteration keeps from one problem to the next.
struct NewtonMemory {
  Eigen::VectorXd velocity, map, trial, trial_map, direction, best, natural;
  Eigen::MatrixXd jacobian;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
};

/// What solve_semismooth_newton keeps from one problem to the next, so that it need not allocate.
struct SemismoothNewtonMemory {
  ScaledProblem scaled;
  Eigen::VectorXd x;
  NewtonMemory newton;
};

struct NewtonOptions {
  double tolerance;  ///< of natural_map_residual
  int most_iterations;
  double largest_step;  ///< of ScaledProblem::adapt_steps, for slow slip near solutions; 0: steps as they are
  double regularisation = 1e-10;  ///< on the Jacobian's diagonal
};

struct NewtonResult {
  int iterations;
  double residual;  ///< natural_map_residual
  bool finite;      ///< whether the last point met had a finite residual, too
};

/// Newton's method on h(x) = 0 from x, which is the best point met on return. The derivative of the
/// projection includes that of the friction domain's size, ∂Π_F/∂(μΠ_N), as in Alart & Curnier (1991). Where
/// W is singular so is the Jacobian: `regularisation` on its diagonal chooses among its solutions and leaves
/// the iteration linear with a factor of that order. Line search: the first of 12 lengths 1, 1/2, 1/4, … that
/// brings ½‖h‖² below the largest of the last five (with adapted steps: below the last); where none does,
/// ½‖h‖² has a minimum or a kink nearby that is no solution, and the full step is taken, away from it.
NewtonResult newton_iteration(ScaledProblem& problem, Eigen::VectorXd& x, const NewtonOptions& options,
                              NewtonMemory& memory);

/// Λ → x: the given impulses or zero, whichever have the smaller residual.
void start(const ContactProblem& problem, const ScaledProblem& scaled, const Eigen::VectorXd& impulse,
           Eigen::VectorXd& velocity, Eigen::VectorXd& x);

/// natural_map_residual of Λ, nothing allocated.
double residual_of(const ContactProblem& problem, const Eigen::VectorXd& impulse, NewtonMemory& memory);

/// The method SolverMethod::semismooth_newton: newton_iteration alone, at most 100 iterations unless limited
/// otherwise. `diverged` where it meets a point that is not finite, `stalled` where the Jacobian is singular.
/// Preconditions: those of ContactSolver::solve's methods, see there.
SolverReport solve_semismooth_newton(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                     const SolverOptions& options, SemismoothNewtonMemory& memory);

}  // namespace contensou
