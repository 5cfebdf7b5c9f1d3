#include "study.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "contensou/contact/blocks.hpp"

namespace verify::augmented {
namespace {

using namespace contensou;

SolverReport run(const Solved& solved, std::optional<double> r, double tolerance, int limit,
                 Eigen::VectorXd& impulse) {
  ContactSolver solver(
      {.method = SolverMethod::modified_newton, .tolerance = tolerance, .max_iterations = limit, .r = r});
  return solver.solve(solved.step.problem, impulse);
}

std::string state_of(const Solved& solved) {
  const Eigen::VectorXd velocity =
      solved.step.problem.delassus * solved.impulse + solved.step.problem.free_velocity;
  std::string all;
  for_each_contact(solved.step.problem, [&](const auto& group, Eigen::Index i) {
    const auto gamma = group.segment(velocity, i).eval();
    const bool stick = gamma.tail(gamma.size() - 1).norm() < 1e-8 * solved.velocity;
    all += (all.empty() ? "" : "+");
    all += group.segment(solved.impulse, i)[0] == 0 ? "open" : stick ? "stick" : "slip";
  });
  return all;
}

}  // namespace

const char* name(SolverStatus status) {
  switch (status) {
    case SolverStatus::solved:
      return "solved";
    case SolverStatus::at_rounding:
      return "rounding";
    case SolverStatus::iteration_limit:
      return "limit";
    case SolverStatus::stalled:
      return "stalled";
    case SolverStatus::diverged:
      return "diverged";
  }
  return "unknown";
}

Solved solve(const TippeTop& top, const Case& c) {
  Solved s{c, augmented::step(top, c), {}, {}, 0, 0, {}};
  s.velocity = s.step.problem.free_velocity.lpNorm<Eigen::Infinity>();
  s.limit = 2 / s.step.problem.delassus.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
  s.report = run(s, {}, 1e-10, 0, s.impulse);
  static_cast<void>(run(s, {}, 1e-13, 0, s.impulse));  // as far as rounding lets it
  s.state = state_of(s);
  return s;
}

Trial attempt(const Solved& solved, double r, int limit) {
  Trial t{r, {}, 0, 0, spectral_radius(solved.step, solved.impulse, r), std::nan(""), 0, std::nan("")};
  // Without a memory the iteration goes on where it stopped.
  Eigen::VectorXd impulse;
  SolverReport report{};
  int done = 0;
  int at_1e7 = 0;
  for (const double tolerance : {1e-6, 1e-7, 1e-10}) {
    if (done >= limit) break;
    report = run(solved, r, tolerance, limit - done, impulse);
    done += report.iterations;
    t.status = report.status;
    if (report.status != SolverStatus::solved) break;
    if (tolerance == 1e-6) t.to_1e6 = done;
    if (tolerance == 1e-7) at_1e7 = done;
    if (tolerance == 1e-10) t.to_1e10 = done;
  }
  if (t.to_1e10 - at_1e7 >= 20) t.measured = std::pow(1e-3, 1.0 / (t.to_1e10 - at_1e7));

  const double scale = solved.impulse.norm();
  Iteration iteration(solved.step, r);
  for (int k = 1; k <= limit; ++k) {
    const Pass pass = iteration.advance();
    if (pass.change > 1e-6 * scale) continue;
    t.printed = k;
    t.printed_error = (pass.impulse - solved.impulse).norm() / scale;
    break;
  }
  return t;
}

}  // namespace verify::augmented
