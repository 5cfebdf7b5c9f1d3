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
// A residual above it is taken for rounding only after some paths: their impulses may be smaller.
constexpr double good = 1e-10;
constexpr int some_paths = 4;
constexpr int most_proximal_steps = 40;
constexpr int most_paths = 24;
constexpr int paths_between = 8;  // between proximal point steps, which then start elsewhere
constexpr int most_path_steps = 300;
// Neither is best for all problems.
constexpr std::array<double, 3> regularisations{1e-7, 1e-5, 1e-9};
constexpr std::array<double, 3> largest_steps{1e3, 1e5, 10};
constexpr std::array<double, 5> newton_regularisations{1e-10, 1e-13, 1e-7, 1e-15, 1e-5};
constexpr std::array<double, 4> newton_steps{1e6, 1e9, 1e3, 30};

/// The rungs share the best impulses met and the number of iterations left.
class Ladder {
 public:
  /// `used`: iterations made before.
  Ladder(const ContactProblem& problem, const SolverOptions& options, int used, AutomaticMemory& memory)
      : problem_(problem),
        wanted_(options.tolerance),
        tolerance_(options.tolerance / 2),
        left_(options.max_iterations > 0 ? std::max(0, options.max_iterations - used)
                                         : std::numeric_limits<int>::max()),
        m_(memory),
        used_(used) {}

  SolverReport climb(Eigen::VectorXd& impulse) {
    m_.scaled.set(problem_);
    start(problem_, m_.scaled, impulse, m_.newton.velocity, m_.x);
    m_.best = m_.x;
    run();
    impulse = m_.best.cwiseProduct(m_.scaled.unit);
    best_ = residual_of(problem_, impulse, m_.newton);
    return {status(), used_, best_, SolverMethod::automatic};
  }

 private:
  SolverStatus status() const {
    if (best_ <= wanted_) return SolverStatus::solved;
    if (m_.scaled.at_rounding(m_.best, best_)) return SolverStatus::at_rounding;
    return left_ <= 0 ? SolverStatus::iteration_limit : SolverStatus::stalled;
  }

  void run() {
    newton(30, 0);
    for (const int count : sweeps_between) {
      if (done()) return;
      sweep(count);
      newton(30, 0);
    }
    m_.x = m_.best;
    if (!done()) proximal();
    for (int attempt = 0; attempt < most_paths && !done(); ++attempt) {
      path(attempt);
      newton(100, newton_steps[static_cast<std::size_t>(attempt) % newton_steps.size()],
             newton_regularisations[static_cast<std::size_t>(attempt) % newton_regularisations.size()]);
      if (done()) return;
      m_.x = m_.path.x;
      sweep(sweeps_after_path);
      newton(30, attempt % 2 == 1 ? newton_steps[0] : 0);
      if (attempt % paths_between == paths_between - 1 && !done()) proximal();
    }
  }

  bool done() const {
    if (left_ <= 0 || best_ <= tolerance_) return true;
    if (paths_ < some_paths && best_ > good) return false;
    return best_ <= m_.scaled.rounding(m_.best);
  }

  void count(int iterations) {
    used_ += iterations;
    left_ -= iterations;
  }

  /// Newton's method on the scaled problem as it stands, from m_.x; its residual.
  double inner_newton(NewtonOptions options) {
    options.most_iterations = std::min(options.most_iterations, left_);
    const NewtonResult result = newton_iteration(m_.scaled, m_.x, options, m_.newton);
    count(result.iterations);
    return result.residual;
  }

  void newton(int most_iterations, double largest_step, double regularisation = newton_regularisations[0]) {
    keep(inner_newton({tolerance_, most_iterations, largest_step, regularisation}));
  }

  /// Remembers m_.x where its residual is the least so far.
  void keep(double residual) {
    if (!(residual < best_)) return;
    best_ = residual;
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

  /// Proximal point steps: each solves the problem with w + ρ1 and b − ρx, which is better conditioned than
  /// the problem itself and has its solution at x where that is the problem's own. ρ shrinks while that
  /// works.
  void proximal() {
    double weight = 1;
    for (int step = 0; step < most_proximal_steps && weight < 1e3 && !done(); ++step) {
      m_.centre = m_.x;
      m_.diagonal = m_.scaled.w.diagonal();
      m_.b = m_.scaled.b;
      m_.scaled.w.diagonal().array() += weight;
      m_.scaled.b -= weight * m_.centre;
      double residual = inner_newton({tolerance_, 30, 0, newton_regularisations[0]});
      if (residual > tolerance_) {
        const double longest = newton_steps[static_cast<std::size_t>(step) % newton_steps.size()];
        residual = inner_newton({tolerance_, 30, longest, newton_regularisations[1]});
      }
      m_.scaled.w.diagonal() = m_.diagonal;
      m_.scaled.b = m_.b;

      m_.scaled.velocity(m_.x, m_.newton.velocity);
      keep(m_.scaled.residual(m_.x, m_.newton.velocity));
      constexpr double near_enough = 1e-6;
      if (residual <= near_enough) {
        weight /= 4;
      } else {
        m_.x = m_.centre;
        weight *= 8;
      }
    }
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
  int used_;
  int paths_ = 0;
  double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace

SolverReport solve_automatic(const ContactProblem& problem, Eigen::VectorXd& impulse,
                             const SolverOptions& options, AutomaticMemory& memory) {
  int used = 0;
  if (problem.contacts() == 1) {
    const SolverReport report = solve_single_contact(problem, impulse, options);
    if (report.status == SolverStatus::solved) return report;
    used = report.iterations;
  }
  return Ladder(problem, options, used, memory).climb(impulse);
}

}  // namespace contensou
