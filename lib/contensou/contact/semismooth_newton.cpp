#include "contensou/contact/semismooth_newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contensou/contact/blocks.hpp"

namespace contensou {
namespace {

constexpr int most_halvings = 12;
constexpr double least_decrease = 2e-4;  // of ½‖h‖² for a full step, Armijo
constexpr std::size_t remembered = 5;
constexpr double farthest = 1e100;  // of a step: beyond it the Jacobian is as good as singular

double merit(const Eigen::VectorXd& h) { return h.squaredNorm() / 2; }

/// The largest of the last merits: now and then ½‖h‖² must be allowed to grow.
class Reference {
 public:
  double with(double latest) {
    merits_[count_++ % remembered] = latest;
    return *std::max_element(merits_.begin(), merits_.end());
  }

 private:
  std::array<double, remembered> merits_{};
  std::size_t count_ = 0;
};

/// m.trial along −m.direction, a fraction that brings h low enough; the full step where no fraction of it
/// does that.
void search(const ScaledProblem& problem, const Eigen::VectorXd& x, double reference, NewtonMemory& m) {
  double length = 1;
  for (int halvings = 0; halvings < most_halvings; ++halvings, length /= 2) {
    m.trial = x - length * m.direction;
    problem.velocity(m.trial, m.velocity);
    problem.natural_map(m.trial, m.velocity, m.trial_map);
    if (merit(m.trial_map) <= (1 - least_decrease * length) * reference) return;
  }
  m.trial = x - m.direction;
}

}  // namespace

NewtonResult newton_iteration(ScaledProblem& problem, Eigen::VectorXd& x, const NewtonOptions& options,
                              NewtonMemory& m) {
  const Eigen::Index n = problem.rows();
  m.jacobian.resize(n, n);
  m.map.resize(n);
  m.trial_map.resize(n);
  m.best = x;
  problem.reset_steps();
  Reference reference;
  NewtonResult result{0, std::numeric_limits<double>::infinity(), true};
  for (;; ++result.iterations) {
    problem.velocity(x, m.velocity);
    const double residual = problem.residual(x, m.velocity);
    if (residual < result.residual) {
      result.residual = residual;
      m.best = x;
    }
    result.finite = std::isfinite(residual);
    if (result.residual <= options.tolerance || result.iterations == options.most_iterations ||
        !result.finite) {
      break;
    }
    if (options.largest_step > 0) problem.adapt_steps(x, m.velocity, options.largest_step);
    problem.natural_map(x, m.velocity, m.map, m.jacobian);
    m.jacobian.diagonal().array() += options.regularisation;
    m.lu.compute(m.jacobian);
    m.direction = m.lu.solve(m.map);
    if (!(m.direction.lpNorm<Eigen::Infinity>() < farthest)) break;
    const double now = merit(m.map);
    search(problem, x, options.largest_step > 0 ? now : reference.with(now), m);
    x = m.trial;
  }
  x = m.best;
  return result;
}

void start(const ContactProblem& problem, const ScaledProblem& scaled, const Eigen::VectorXd& impulse,
           Eigen::VectorXd& velocity, Eigen::VectorXd& x) {
  x.setZero(problem.rows());
  if (impulse.isZero(0)) return;
  const double cold = scaled.residual(x, scaled.b);
  x = impulse.cwiseQuotient(scaled.unit);
  scaled.velocity(x, velocity);
  if (!(scaled.residual(x, velocity) <= cold)) x.setZero();
}

double residual_of(const ContactProblem& problem, const Eigen::VectorXd& impulse, NewtonMemory& m) {
  natural_steps(problem, m.natural);
  m.velocity.resize(problem.rows());
  certified_velocity(problem, impulse, m.velocity);
  return natural_map_residual(problem, impulse, m.velocity, m.natural);
}

SolverReport solve_semismooth_newton(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                     const SolverOptions& options, SemismoothNewtonMemory& memory) {
  const int limit = options.max_iterations > 0 ? options.max_iterations : 100;
  memory.scaled.set(problem);
  start(problem, memory.scaled, impulse, memory.newton.velocity, memory.x);
  NewtonResult result =
      newton_iteration(memory.scaled, memory.x, {options.tolerance / 2, limit, 0}, memory.newton);
  impulse = memory.x.cwiseProduct(memory.scaled.unit);
  result.residual = residual_of(problem, impulse, memory.newton);
  const auto status = [&] {
    if (result.residual <= options.tolerance) return SolverStatus::solved;
    if (memory.scaled.at_rounding(memory.x, result.residual)) return SolverStatus::at_rounding;
    if (!result.finite) return SolverStatus::diverged;
    return result.iterations < limit ? SolverStatus::stalled : SolverStatus::iteration_limit;
  };
  return {status(), result.iterations, result.residual, SolverMethod::semismooth_newton};
}

}  // namespace contensou
