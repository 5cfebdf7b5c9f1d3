#include "contensou/contact/automatic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "contensou/contact/single_contact.hpp"

namespace contensou {
namespace {

constexpr std::array sweeps_between{10, 30, 90};
constexpr int sweeps_after_path = 20;
constexpr double good =
    1e-10;  // a residual above it is rounding only after some paths: their impulses may be smaller
constexpr int most_paths = 24;
constexpr int most_path_steps = 300;
// Neither is best for all problems.
constexpr std::array<double, 3> regularisations{1e-7, 1e-5, 1e-9};
constexpr std::array<double, 3> largest_steps{1e3, 1e5, 10};
constexpr std::array<double, 5> newton_regularisations{1e-10, 1e-13, 1e-7, 1e-15, 1e-5};
constexpr std::array<double, 4> newton_steps{1e6, 1e9, 1e3, 30};

/// The rungs share the best impulses met and the number of iterations left.
class Ladder {
 public:
  Ladder(const ContactProblem& problem, const SolverOptions& options, AutomaticMemory& memory)
      : problem_(problem),
        wanted_(options.tolerance),
        tolerance_(options.tolerance / 2),
        left_(options.max_iterations > 0 ? options.max_iterations : std::numeric_limits<int>::max()),
        m_(memory) {}

  SolverReport climb(Eigen::VectorXd& impulse) {
    m_.scaled.set(problem_);
    start(problem_, m_.scaled, impulse, m_.newton.velocity, m_.x);
    m_.best = m_.x;
    run();
    impulse = m_.best.cwiseProduct(m_.scaled.unit);
    best_ = residual_of(problem_, impulse, m_.newton);
    const SolverStatus status = best_ <= wanted_ ? SolverStatus::solved
                                : left_ <= 0     ? SolverStatus::iteration_limit
                                                 : SolverStatus::stalled;
    return {status, used_, best_, SolverMethod::automatic};
  }

 private:
  void run() {
    newton(30, 0);
    for (const int count : sweeps_between) {
      if (done()) return;
      sweep(count);
      newton(30, 0);
    }
    for (int attempt = 0; attempt < most_paths && !done(); ++attempt) {
      path(attempt);
      newton(100, newton_steps[static_cast<std::size_t>(attempt) % newton_steps.size()],
             newton_regularisations[static_cast<std::size_t>(attempt) % newton_regularisations.size()]);
      if (done()) return;
      m_.x = m_.path.x;
      sweep(sweeps_after_path);
      newton(30, attempt % 2 == 1 ? newton_steps[0] : 0);
    }
  }

  bool done() const {
    if (left_ <= 0 || best_ <= tolerance_) return true;
    if (paths_ < 4 && best_ > good) return false;
    return best_ <= m_.scaled.rounding(m_.best);
  }

  void count(int iterations) {
    used_ += iterations;
    left_ -= iterations;
  }

  void newton(int most_iterations, double largest_step, double regularisation = 1e-10) {
    const NewtonResult result = newton_iteration(
        m_.scaled, m_.x, {tolerance_, std::min(most_iterations, left_), largest_step, regularisation},
        m_.newton);
    count(result.iterations);
    if (!(result.residual < best_)) return;
    best_ = result.residual;
    m_.best = m_.x;
  }

  void sweep(int most_sweeps) {
    m_.impulse = m_.x.cwiseProduct(m_.scaled.unit);
    const SolverReport report = solve_gauss_seidel(
        problem_, m_.impulse,
        {.tolerance = tolerance_, .max_iterations = std::max(1, std::min(most_sweeps, left_))},
        m_.gauss_seidel);
    count(report.iterations);
    m_.x = m_.impulse.cwiseQuotient(m_.scaled.unit);
  }

  /// Directions from 1/4 to 4 in the normal rows, spread by the golden section; all 1 the first time.
  void path(int attempt) {
    double place = 0;
    for (double& cover : m_.scaled.cover) {
      if (cover == 0) continue;
      place += 0.6180339887498949 * attempt;
      cover = attempt == 0 ? 1 : std::exp2(4 * (place - std::floor(place)) - 2);
    }
    const auto which = static_cast<std::size_t>(attempt) % regularisations.size();
    count(follow_covering_path(
        m_.scaled, {regularisations[which], largest_steps[which], std::min(most_path_steps, left_)},
        m_.path));
    m_.x = m_.path.x;
    ++paths_;
  }

  const ContactProblem& problem_;
  double wanted_;
  double tolerance_;  ///< that of the rungs: what rounding makes of it in other units is left room for
  int left_;
  AutomaticMemory& m_;
  int used_ = 0;
  int paths_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace

SolverReport solve_automatic(const ContactProblem& problem, Eigen::VectorXd& impulse,
                             const SolverOptions& options, AutomaticMemory& memory) {
  if (problem.contacts() == 1) {
    const SolverReport report = solve_single_contact(problem, impulse, options);
    if (report.status == SolverStatus::solved) return report;
  }
  return Ladder(problem, options, memory).climb(impulse);
}

}  // namespace contensou
