#include "uniqueness.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "contensou/contact/blocks.hpp"

namespace verify::consistency {

using contensou::ContactProblem;
using contensou::TypedGroup;

Uniqueness uniqueness(const ContactProblem& problem) {
  // No law of the generator has a ball that reaches further: ξ <= 1, η <= 2/3, ξ² + η² <= 1 but for the
  // ellipsoid's rounding; pressures at the rim would reach ξ² + η² = 1.
  constexpr double reach = 1;
  constexpr double largest_q = 0.9;
  Uniqueness u{false, Eigen::VectorXd::Zero(problem.rows()), 0};
  double mu = 0;
  contensou::for_each_contact(problem, [&]<class D>(const TypedGroup<D>& group, Eigen::Index i) {
    if constexpr (D::dimension > 0) mu = std::max(mu, group.mu[i]);
    const Eigen::Index row = group.row(i);
    constexpr Eigen::Index plane = D::dimension == 0 ? 1 : 3;
    const double s = 1 / std::sqrt(problem.delassus.diagonal().segment(row, plane).maxCoeff());
    u.scale.segment(row, plane).setConstant(s);
    if constexpr (D::dimension == 3) {
      u.scale[row + 3] = std::max(s, 1 / std::sqrt(problem.delassus(row + 3, row + 3)));
    }
  });
  if (!u.scale.allFinite()) return u;
  const Eigen::MatrixXd scaled = u.scale.asDiagonal() * problem.delassus * u.scale.asDiagonal();
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  const double least = values[0] - 1e-14 * values[values.size() - 1];
  if (!(least > 0)) return u;
  const double root = std::sqrt(values[values.size() - 1] / least);
  const double q = mu * reach * root;
  u.proven = q <= largest_q;
  u.amplification = (1 + mu * reach) * root / (1 - q) + 1;
  return u;
}

double disturbance(const ContactProblem& problem, const Uniqueness& u, const Solution& s) {
  constexpr double sum = 33 * 0x1p-53;    // of n <= 32 products and b
  constexpr double projection = 0x1p-50;  // 4 ulp
  const Eigen::VectorXd exact = problem.delassus * s.defect - s.defect.cwiseQuotient(s.step);
  const Eigen::VectorXd noise =
      sum * (problem.delassus.cwiseAbs() * s.impulse.cwiseAbs() + problem.free_velocity.cwiseAbs()) +
      projection * (s.impulse.cwiseQuotient(s.step) + s.velocity).cwiseAbs();
  return u.scale.cwiseProduct(exact).norm() + u.scale.cwiseProduct(noise).norm();
}

}  // namespace verify::consistency
