#include "patch.hpp"

namespace verify::siconos {
namespace {

/// The patch's (λ_N, λ_F) from the reactions of the N + 1 contacts.
Eigen::Matrix4Xd resultant(const std::vector<PatchPoint>& points) {
  Eigen::Matrix4Xd sum = Eigen::Matrix4Xd::Zero(4, 3 * static_cast<Eigen::Index>(points.size() + 1));
  sum(0, 0) = 1;
  Eigen::Index row = 3;
  for (const PatchPoint& p : points) {
    sum.block<3, 2>(1, row + 1) << 1, 0, 0, 1, -p.y, p.x;
    row += 3;
  }
  return sum;
}

}  // namespace

rivals::SiconosProblem cut(const PatchContact& contact, const std::vector<PatchPoint>& points) {
  const Eigen::Matrix4Xd sum = resultant(points);
  Eigen::MatrixXd w = sum.transpose() * contact.w * sum;
  Eigen::VectorXd q = sum.transpose() * contact.b;
  std::vector<double> mu(points.size() + 1, contact.mu);
  // The first contact's tangential rows say that nothing happens in them.
  mu[0] = 0;
  w(1, 1) = w(2, 2) = contact.w(0, 0);
  Eigen::Index row = 3;
  for (const PatchPoint& p : points) {
    w(row, row) = contact.w(0, 0);
    w(row, 0) = -p.weight * contact.w(0, 0);
    row += 3;
  }
  return {w, q, mu, rivals::SiconosProblem::Storage::blocks};
}

PatchSolution solve_cut(const PatchContact& contact, const std::vector<PatchPoint>& points,
                        const std::string& method, double tolerance, int max_iterations) {
  rivals::SiconosProblem problem = cut(contact, points);
  rivals::SiconosSolver solver(method, tolerance, max_iterations);
  const auto rows = 3 * static_cast<Eigen::Index>(points.size() + 1);
  Eigen::VectorXd reaction = Eigen::VectorXd::Zero(rows);
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(rows);
  const rivals::SiconosOutcome outcome = solver.solve(problem, reaction, velocity);
  PatchSolution solution;
  solution.force = resultant(points) * reaction;
  solution.velocity = contact.w * solution.force + contact.b;
  solution.error = problem.error(reaction);
  solution.info = outcome.info;
  solution.iterations = outcome.iterations;
  return solution;
}

}  // namespace verify::siconos
