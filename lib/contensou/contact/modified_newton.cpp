#include "contensou/contact/modified_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/contact/blocks.hpp"

namespace contensou {
namespace {

constexpr int default_limit = 20000;
constexpr int patience = 2000;          // iterations without progress, before giving up
constexpr double progress = 1e-6;       // of the residual, what counts as such
constexpr int window = 200;             // iterations without a better residual, before ω is bounded anew
constexpr double growth = 1e12;         // of the impulses over the first step: divergence
constexpr double setback = 1e3;         // of the residual over the best: the factor ω was too large
constexpr double largest_factor = 1e8;  // of ω
constexpr double smallest_factor = 0x1p-30;

/// The factor ω on the safe steps: curvature's proposal under a bound that learns.
class Factor {
 public:
  /// ω for the step from Λ with velocity γ, the last step having come from previous_impulse.
  double propose(const ContactProblem& problem, const Eigen::VectorXd& impulse,
                 const ModifiedNewtonMemory& m) {
    double length = 0;
    double work = 0;
    double response = 0;
    for_each_contact(problem, [&](const auto& group, Eigen::Index i) {
      const double s = m.safe_step[group.first_contact + i];
      const auto change = (group.segment(impulse, i) - group.segment(m.previous_impulse, i)).eval();
      const auto answer = (group.segment(m.velocity, i) - group.segment(m.previous_velocity, i)).eval();
      length += change.squaredNorm() / s;
      work += change.dot(answer);
      response += answer.squaredNorm() * s;
    });
    long_ = !long_;
    const double factor = long_ ? length / work : work / response;
    return std::min(work > 0 && std::isfinite(factor) && factor > 0 ? factor : 1, bound_);
  }
  /// For the first step from a new place.
  double first() const { return std::min(1.0, bound_); }
  void found_better() { bound_ = std::min(1.1 * bound_, largest_factor); }
  /// False where nothing smaller is left to try.
  bool reduce() {
    bound_ /= 10;
    return bound_ >= smallest_factor;
  }

 private:
  double bound_ = largest_factor;
  bool long_ = false;
};

/// Λ ← Π(Λ − rγ), contact by contact; r(contact) [kg]. False where the argument is not finite.
template <class Step>
bool project_all(const ContactProblem& problem, Eigen::VectorXd& impulse, const Eigen::VectorXd& velocity,
                 Step&& r) {
  bool finite = true;
  for_each_contact(problem, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    auto lambda = group.segment(impulse, i);
    const ContactVector<Domain> x = lambda - r(group.first_contact + i) * group.segment(velocity, i);
    if (x.allFinite()) {
      lambda = project_contact(group.domain, group.mu[static_cast<std::size_t>(i)], x);
    } else {
      finite = false;
    }
  });
  return finite;
}

}  // namespace

void safe_steps(const ContactProblem& problem, Eigen::VectorXd& step) {
  natural_steps(problem, step);
  for_each_contact(problem, [&](const auto& group, Eigen::Index i) {
    const double norm =
        row_sum_norm(problem.delassus.middleRows(group.row(i), std::decay_t<decltype(group)>::rows));
    if (norm >= std::numeric_limits<double>::min()) step[group.first_contact + i] = 1 / norm;
  });
}

SolverReport solve_modified_newton(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                   const SolverOptions& options, ModifiedNewtonMemory& m) {
  const int limit = options.max_iterations > 0 ? options.max_iterations : default_limit;
  natural_steps(problem, m.natural_step);
  if (!options.r) safe_steps(problem, m.safe_step);
  const auto evaluate = [&] {
    m.velocity = problem.free_velocity;
    m.velocity.noalias() += problem.delassus * impulse;
  };
  m.best = impulse;
  evaluate();

  Factor factor;
  double best = std::numeric_limits<double>::infinity();
  double milestone = best;  // the residual that progress is measured from
  int reached = 0;          // when
  int bounded = 0;          // when ω was, or last proved good
  double first_size = 0;
  bool fresh = true;  // there is no step behind Λ to take the curvature from
  const auto finish = [&](SolverStatus status, int iterations) {
    impulse = m.best;
    certified_velocity(problem, impulse, m.velocity);
    const double certified = natural_map_residual(problem, impulse, m.velocity, m.natural_step);
    if (status == SolverStatus::solved && certified > options.tolerance) status = SolverStatus::at_rounding;
    return SolverReport{status, iterations, certified, SolverMethod::modified_newton};
  };
  for (int k = 0;; ++k) {
    const double residual = natural_map_residual(problem, impulse, m.velocity, m.natural_step);
    if (residual < best) {
      best = residual;
      m.best = impulse;
      factor.found_better();
      bounded = k;
    }
    if (residual <= options.tolerance) return finish(SolverStatus::solved, k);
    if (best < (1 - progress) * milestone) {
      milestone = best;
      reached = k;
    }
    if (k - reached >= patience) return finish(SolverStatus::stalled, k);
    if (k == limit) return finish(SolverStatus::iteration_limit, k);

    const bool lost = !(residual <= setback * best);
    if (!options.r && (lost || k - bounded >= window)) {
      if (!factor.reduce()) return finish(SolverStatus::stalled, k);
      bounded = k;
      if (lost) {
        impulse = m.best;
        evaluate();
      }
      fresh = true;
    }
    const double omega = options.r ? 0 : fresh ? factor.first() : factor.propose(problem, impulse, m);
    fresh = false;
    m.previous_impulse = impulse;
    m.previous_velocity = m.velocity;
    const bool finite =
        options.r ? project_all(problem, impulse, m.velocity, [&](Eigen::Index) { return *options.r; })
                  : project_all(problem, impulse, m.velocity,
                                [&](Eigen::Index i) { return omega * m.safe_step[i]; });
    const double size = impulse.lpNorm<Eigen::Infinity>();
    if (k == 0) first_size = std::max(size, m.best.lpNorm<Eigen::Infinity>());
    if (!finite || (first_size > 0 && size > growth * first_size))
      return finish(SolverStatus::diverged, k + 1);
    if (impulse == m.previous_impulse) return finish(SolverStatus::stalled, k + 1);
    evaluate();
  }
}

}  // namespace contensou
