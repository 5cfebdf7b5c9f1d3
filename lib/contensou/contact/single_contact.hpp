#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// The problem of a single contact, at once, by solve_one_contact (one_contact.hpp) on pieces of fixed size;
/// allocates nothing. options.max_iterations is not heeded: it ends by a limit of its own. `stalled` where
/// the tolerance is not reached: then the caller has to go on by other means, from `impulse`, which is what
/// was given unless something better was found.
///
/// `problem` has one contact; else the preconditions of ContactSolver::solve's methods, see there.
SolverReport solve_single_contact(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                  const SolverOptions& options);

}  // namespace contensou
