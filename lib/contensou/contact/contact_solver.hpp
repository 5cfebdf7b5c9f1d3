#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

/// The solvers of the contact problem.
enum class SolverMethod {
  modified_newton,    ///< LG03 4.1: augmented Lagrangian, projection; simple, slow; as printed with r given
  gauss_seidel,       ///< projected block Gauss–Seidel: contact after contact, each solved exactly
  semismooth_newton,  ///< Newton's method on the augmented-Lagrangian equations, with a line search
  automatic,          ///< one contact at once; several by semismooth Newton, with all else behind it
};

struct SolverOptions {
  SolverMethod method = SolverMethod::automatic;
  double tolerance = 1e-12;  ///< of natural_map_residual
  int max_iterations = 0;    ///< 0: the method's own limit
  /// modified_newton only [kg]; not given: from the curvature, see modified_newton.hpp.
  std::optional<double> r = {};
};

enum class SolverStatus {
  solved,           ///< residual <= tolerance
  at_rounding,      ///< not so, but by no more than the rounding of impulses and velocities to doubles
  iteration_limit,  ///< not reached within the iterations allowed
  stalled,          ///< no further progress is possible (rounding, a local minimum, a cycle)
  diverged,         ///< not finite, or growing without bound
};

/// What a solver reached. The caller cannot ignore it.
struct [[nodiscard]] SolverReport {
  SolverStatus status;
  int iterations;
  double residual;      ///< natural_map_residual of the impulses returned
  SolverMethod method;  ///< the one asked for
};

/// A solver and its memory: nothing is allocated in `solve` once problems stop growing.
class ContactSolver {
 public:
  /// Throws std::invalid_argument for a tolerance, a limit or an r that makes no sense.
  explicit ContactSolver(const SolverOptions& options = {});
  ~ContactSolver();
  ContactSolver(ContactSolver&&) noexcept;
  ContactSolver& operator=(ContactSolver&&) noexcept;

  /// `impulse`: on entry the initial guess (warm start: the impulses of the last step; of the wrong size it
  /// counts as none), on return the best Λ found, whatever the status. Throws std::invalid_argument as
  /// require_valid does. Ends after a bounded number of iterations, always.
  ///
  /// What the methods behind it (solve_automatic and so on) are called with, and do not check: options and
  /// `problem` are valid, b is not zero, `impulse` has the right size and is finite.
  SolverReport solve(const ContactProblem& problem, Eigen::VectorXd& impulse);

 private:
  struct Memory;
  SolverOptions options_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace contensou
