#pragma once

#include <Eigen/Core>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace contensou {

/// The problem of a single contact, at once, by solve_one_contact (one_contact.hpp) on pieces of fixed size;
/// allocates nothing. `stalled` where the tolerance is not reached: then the caller has to go on by other
/// means.
///
/// `problem` is valid and has one contact, b is not zero, `impulse` has the right size and is finite.
SolverReport solve_single_contact(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                  const SolverOptions& options);

}  // namespace contensou
