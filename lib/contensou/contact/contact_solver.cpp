#include "contensou/contact/contact_solver.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "contensou/contact/automatic.hpp"
#include "contensou/contact/gauss_seidel.hpp"
#include "contensou/contact/modified_newton.hpp"
#include "contensou/contact/semismooth_newton.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

void require_valid(const SolverOptions& options) {
  const auto fail = [](const std::string& what) { throw std::invalid_argument("contact solver: " + what); };
  if (!(options.tolerance > 0 && std::isfinite(options.tolerance))) {
    fail("tolerance = " + to_text(options.tolerance) + ", expected a finite number > 0");
  }
  if (options.max_iterations < 0) {
    fail("max_iterations = " + std::to_string(options.max_iterations) + ", expected >= 0");
  }
  if (!options.r) return;
  if (!(*options.r > 0 && std::isfinite(*options.r))) {
    fail("r = " + to_text(*options.r) + ", expected a finite number > 0");
  }
  if (options.method != SolverMethod::modified_newton) fail("r is given, but only modified_newton uses it");
}

}  // namespace

struct ContactSolver::Memory {
  ModifiedNewtonMemory modified_newton;
  GaussSeidelMemory gauss_seidel;
  SemismoothNewtonMemory semismooth_newton;
  AutomaticMemory automatic;
};

ContactSolver::ContactSolver(const SolverOptions& options)
    : options_(options), memory_(std::make_unique<Memory>()) {
  require_valid(options);
}

ContactSolver::~ContactSolver() = default;
ContactSolver::ContactSolver(ContactSolver&&) noexcept = default;
ContactSolver& ContactSolver::operator=(ContactSolver&&) noexcept = default;

SolverReport ContactSolver::solve(const ContactProblem& problem, Eigen::VectorXd& impulse) {
  require_valid(problem);
  if (impulse.size() != problem.rows() || !impulse.allFinite()) impulse.setZero(problem.rows());
  if (problem.free_velocity.isZero(0)) {  // nothing moves, nothing has to stop it
    impulse.setZero();
    return {SolverStatus::solved, 0, 0, options_.method};
  }
  switch (options_.method) {
    case SolverMethod::modified_newton:
      return solve_modified_newton(problem, impulse, options_, memory_->modified_newton);
    case SolverMethod::gauss_seidel:
      return solve_gauss_seidel(problem, impulse, options_, memory_->gauss_seidel);
    case SolverMethod::semismooth_newton:
      return solve_semismooth_newton(problem, impulse, options_, memory_->semismooth_newton);
    case SolverMethod::automatic:
      return solve_automatic(problem, impulse, options_, memory_->automatic);
  }
  throw std::logic_error("contact solver: unknown method");
}

}  // namespace contensou
