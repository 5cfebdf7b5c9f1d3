#include "iteration.hpp"

#include <Eigen/Eigenvalues>
#include <complex>

#include "contensou/contact/blocks.hpp"

namespace verify::augmented {

using namespace contensou;

Eigen::VectorXd project(const Step& step, const Eigen::VectorXd& impulse, const Eigen::VectorXd& velocity,
                        double r) {
  Eigen::VectorXd result = impulse;
  for_each_contact(step.problem, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    const ContactVector<Domain> x = group.segment(impulse, i) - r * group.segment(velocity, i);
    group.segment(result, i) = project_contact(group.domain, group.mu[i], x);
  });
  return result;
}

Iteration::Iteration(const Step& step, double r, Reading reading)
    : step_(step),
      r_(r),
      reading_(reading),
      mass_(step.mass),
      impulse_(Eigen::VectorXd::Zero(step.w.cols())),
      u_(step.u) {}

Pass Iteration::advance() {
  const Vector6 change = mass_.solve(step_.smooth + step_.w * impulse_);
  const Eigen::VectorXd next = project(step_, impulse_, step_.w.transpose() * (change + u_), r_);
  if (reading_ == Reading::iterate) u_ = step_.u + change;
  if (reading_ == Reading::accumulate) u_ += change;

  double normal = 0;
  double friction = 0;
  for_each_contact(step_.problem, [&](const auto& group, Eigen::Index i) {
    const auto d = (group.segment(next, i) - group.segment(impulse_, i)).eval();
    normal += d[0] * d[0];
    friction += d.tail(d.size() - 1).squaredNorm();
  });
  impulse_ = next;
  return {next, std::sqrt(normal) + std::sqrt(friction)};
}

double spectral_radius(const Step& step, const Eigen::VectorXd& impulse, double r) {
  const auto pass = [&](const Eigen::VectorXd& x) {
    return project(step, x, step.problem.delassus * x + step.problem.free_velocity, r);
  };
  // Third derivatives are of the size of 1/Λ²: an error of 1e-12; rounding 1e-16/1e-6.
  const double h = 1e-6 * impulse.lpNorm<Eigen::Infinity>();
  Eigen::MatrixXd derivative(impulse.size(), impulse.size());
  for (Eigen::Index j = 0; j < impulse.size(); ++j) {
    const Eigen::VectorXd shift = h * Eigen::VectorXd::Unit(impulse.size(), j);
    derivative.col(j) = (pass(impulse + shift) - pass(impulse - shift)) / (2 * h);
  }
  constexpr double noise = 1e-9;  // ten times that of the differences
  double radius = 0;
  for (const std::complex<double>& rate : derivative.eigenvalues()) {
    if (std::abs(rate - 1.0) > noise) radius = std::max(radius, std::abs(rate));
  }
  return radius;
}

}  // namespace verify::augmented
