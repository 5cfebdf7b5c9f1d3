#include "contensou/contact/single_contact.hpp"

#include "contensou/contact/blocks.hpp"
#include "contensou/contact/one_contact.hpp"

namespace contensou {

SolverReport solve_single_contact(const ContactProblem& problem, Eigen::VectorXd& impulse,
                                  const SolverOptions& options) {
  SolverReport report{SolverStatus::stalled, 0, 0, SolverMethod::automatic};
  for_each_contact(problem, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    const ContactMatrix<Domain> w = group.block(problem.delassus, 0);
    const ContactVector<Domain> b = group.segment(problem.free_velocity, 0);
    const ContactVector<Domain> guess = group.segment(impulse, 0);
    const double mu = group.mu[i];
    const auto residual = [&](const ContactVector<Domain>& lambda) {
      const ContactVector<Domain> velocity = w * lambda + b;
      return contact_residual<Domain>(group.domain, mu, lambda, velocity, natural_step(row_sum_norm(w), 1),
                                      b.cwiseAbs().maxCoeff());
    };
    const auto solution = solve_one_contact<Domain>(group.domain, mu, w, b, guess);
    report.iterations = solution.iterations;
    report.residual = residual(solution.impulse);
    if (!(report.residual <= options.tolerance)) {
      const double before = residual(guess);
      if (!(report.residual < before)) {
        report.residual = before;
        return;
      }
    }
    group.segment(impulse, 0) = solution.impulse;
  });
  if (report.residual <= options.tolerance) report.status = SolverStatus::solved;
  return report;
}

}  // namespace contensou
