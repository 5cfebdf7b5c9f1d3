#include "checks.hpp"

#include <algorithm>
#include <cmath>

#include "contact/potential.hpp"
#include "contensou/contact/blocks.hpp"
#include "contensou/contact/contact_solver.hpp"
#include "worst.hpp"

namespace verify::consistency {

using contensou::ContactProblem;
using contensou::ContactVector;
using contensou::TypedGroup;

Solution solve(const ContactProblem& problem, int most_iterations) {
  contensou::ContactSolver solver({.tolerance = 1e-12, .max_iterations = most_iterations});
  Solution s;
  const contensou::SolverReport report = solver.solve(problem, s.impulse);
  s.residual = report.residual;
  s.at_rounding = report.status == contensou::SolverStatus::at_rounding;
  s.velocity = problem.delassus * s.impulse + problem.free_velocity;
  s.speed = problem.free_velocity.lpNorm<Eigen::Infinity>();
  Eigen::VectorXd step;
  contensou::natural_steps(problem, step);
  s.step.resizeLike(s.impulse);
  s.defect.resizeLike(s.impulse);
  contensou::for_each_contact(problem, [&]<class D>(const TypedGroup<D>& group, Eigen::Index i) {
    const double r = step[group.first_contact + i];
    const ContactVector<D> lambda = group.segment(s.impulse, i);
    const ContactVector<D> x = lambda - r * group.segment(s.velocity, i);
    group.segment(s.step, i).setConstant(r);
    group.segment(s.defect, i) = lambda - contensou::project_contact(group.domain, group.mu[i], x);
  });
  return s;
}

Power frictional_power(const ContactProblem& problem, const Solution& s) {
  // Zero where no contact has friction, or none moves.
  Worst created(0);
  Worst apart(0);
  int slipping = 0;
  contensou::for_each_contact(problem, [&]<class D>(const TypedGroup<D>& group, Eigen::Index i) {
    if constexpr (D::dimension > 0) {
      const double mu = group.mu[i];
      const double r = s.step[group.row(i)];
      const double normal = std::max(0.0, s.impulse[group.row(i)]);  // below zero within the residual
      const Eigen::Matrix<double, D::dimension, 1> force =
          group.segment(s.impulse, i).template tail<D::dimension>();
      const Eigen::Matrix<double, D::dimension, 1> gamma =
          group.segment(s.velocity, i).template tail<D::dimension>();
      const double scale = s.speed * (mu * normal + force.norm() + (1 + mu) * r * gamma.norm());
      if (scale == 0) return;
      const double power = force.dot(gamma);
      const double spin = D::dimension == 3 ? std::abs(gamma[D::dimension - 1]) : 0;
      const double potential =
          mu * normal * random_contact::Potential{}(group.domain, gamma.template head<2>().norm(), spin);
      created.add(power / scale);
      apart.add(std::abs(power + potential) / scale);
      if (mu * normal > 0 && gamma.norm() > 1e-8 * s.speed) ++slipping;
    }
  });
  return {created.value(), apart.value(), slipping};
}

double energy_gained(const Solution& s, const Eigen::VectorXd& velocity_before) {
  const double scale = s.speed * (s.impulse.lpNorm<1>() + s.step.cwiseProduct(s.velocity).lpNorm<1>());
  return scale == 0 ? 0 : s.impulse.dot(s.velocity + velocity_before) / 2 / scale;
}

ContactProblem reversed(const ContactProblem& problem, std::vector<Eigen::Index>& rows) {
  rows.clear();
  ContactProblem result;
  Eigen::Index end = problem.rows();
  for (auto group = problem.groups.rbegin(); group != problem.groups.rend(); ++group) {
    const Eigen::Index width = contensou::rows(*group->friction);
    result.groups.push_back({group->friction, {group->mu.rbegin(), group->mu.rend()}});
    for (std::size_t i = 0; i < group->mu.size(); ++i) {
      end -= width;
      for (Eigen::Index k = 0; k < width; ++k) rows.push_back(end + k);
    }
  }
  result.delassus = problem.delassus(rows, rows);
  result.free_velocity = problem.free_velocity(rows);
  return result;
}

}  // namespace verify::consistency
