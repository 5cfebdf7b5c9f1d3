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
    const auto solution = solve_one_contact<Domain>(group.domain, mu, w, b, guess);
    group.segment(impulse, 0) = solution.impulse;
    report.iterations = solution.iterations;
    const ContactVector<Domain> velocity = w * solution.impulse + b;
    report.residual = contact_residual<Domain>(group.domain, mu, solution.impulse, velocity,
                                               natural_step(row_sum_norm(w), 1), b.cwiseAbs().maxCoeff());
  });
  if (report.residual <= options.tolerance) report.status = SolverStatus::solved;
  return report;
}

}  // namespace contensou
