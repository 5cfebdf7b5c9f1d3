#include "contensou/contact/gauss_seidel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/contact/blocks.hpp"
#include "contensou/contact/one_contact.hpp"

namespace contensou {
namespace {

constexpr int most_sweeps = 5000;
constexpr int sweeps_between_looks = 16;
constexpr int looks_without_progress = 40;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Solves each contact once, for what the others are; returns the largest change of a contact's own
/// velocity, W_ii ΔΛ_i; infinity where a velocity or an impulse overflows: that contact is left as it is.
double sweep(const ContactProblem& problem, const Eigen::VectorXd& step, Eigen::VectorXd& impulse,
             Eigen::VectorXd& velocity) {
  double largest = 0;
  for_each_contact(problem, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    constexpr int rows = TypedGroup<Domain>::rows;
    const ContactMatrix<Domain> w = group.block(problem.delassus, i);
    const ContactVector<Domain> old = group.segment(impulse, i);
    const ContactVector<Domain> b = group.segment(velocity, i) - w * old;
    if (!b.allFinite()) {
      largest = infinity;
      return;
    }
    const auto exact = solve_one_contact(group.domain, group.mu[i], w, b, old);
    if (exact.state == ContactState::unsolved) return;
    if (!exact.impulse.allFinite()) {
      largest = infinity;
      return;
    }
    const ContactVector<Domain> change = exact.impulse - old;
    if (change.isZero(0)) return;
    group.segment(impulse, i) = exact.impulse;
    velocity.noalias() += problem.delassus.middleCols<rows>(group.row(i)) * change;
    largest = std::max(largest, change.cwiseAbs().maxCoeff() / step[group.first_contact + i]);
  });
  return largest;
}

}  // namespace

SolverReport solve_gauss_seidel(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                const SolverOptions& options, GaussSeidelMemory& memory) {
  const int limit = options.max_iterations > 0 ? options.max_iterations : most_sweeps;
  const double goal = options.tolerance * problem.free_velocity.lpNorm<Eigen::Infinity>();
  natural_steps(problem, memory.step);
  const auto look = [&] {  // also takes away what rounding has added up
    memory.velocity = problem.free_velocity;
    memory.velocity.noalias() += problem.delassus * impulse;
    return natural_map_residual(problem, impulse, memory.velocity, memory.step);
  };

  double residual = look();
  double best_residual = residual;
  double reference = residual;  // a tenth below it is progress
  memory.best = impulse;
  int looks = 0;
  int sweeps = 0;
  SolverStatus status = SolverStatus::iteration_limit;
  while (best_residual > options.tolerance && sweeps < limit) {
    const double change = sweep(problem, memory.step, impulse, memory.velocity);
    ++sweeps;
    const bool regular = sweeps == 1 || sweeps % sweeps_between_looks == 0;
    if (!(change <= goal || regular || sweeps == limit || !std::isfinite(change))) continue;
    residual = look();
    if (residual < best_residual) {
      best_residual = residual;
      memory.best = impulse;
    }
    if (!std::isfinite(residual)) {
      status = SolverStatus::diverged;
      break;
    }
    if (best_residual < 0.9 * reference) {
      reference = best_residual;
      looks = 0;
    } else if (++looks > looks_without_progress || change == 0) {
      status = SolverStatus::stalled;
      break;
    }
  }
  impulse = memory.best;
  certified_velocity(problem, impulse, memory.velocity);
  const double certified = natural_map_residual(problem, impulse, memory.velocity, memory.step);
  if (best_residual <= options.tolerance) {
    status = certified <= options.tolerance ? SolverStatus::solved : SolverStatus::at_rounding;
  }
  return {status, sweeps, certified, SolverMethod::gauss_seidel};
}

}  // namespace contensou
