#include "contensou/contact/scaled_problem.hpp"

#include <algorithm>
#include <limits>

#include "contensou/contact/blocks.hpp"

namespace contensou {

void ScaledProblem::set(const ContactProblem& problem) {
  constexpr double negligible = 1e-8;  // a diagonal entry beside the rest of W_ii that no step is made from
  problem_ = &problem;
  natural_steps(problem, natural_);
  const double speed = problem.free_velocity.lpNorm<Eigen::Infinity>();
  b = problem.free_velocity / speed;
  w = problem.delassus;
  unit.resize(b.size());
  reset_step_.resize(b.size());
  cover.setZero(b.size());
  for_each_contact(problem, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    constexpr int size = TypedGroup<Domain>::rows;
    double& natural = natural_[group.first_contact + i];
    const ContactVector<Domain> diagonal = group.block(problem.delassus, i).diagonal() * natural;
    double friction = 0;
    if constexpr (size > 1) friction = std::max(diagonal[1], diagonal[2]);
    const double largest = std::max(diagonal[0], friction);
    const double r = largest > negligible ? natural / largest : natural;
    const auto step = [&](double entry) { return entry > negligible * largest ? largest / entry : 1; };
    group.segment(unit, i).setConstant(r * speed);
    group.segment(reset_step_, i).setConstant(step(friction));
    reset_step_[group.row(i)] = step(diagonal[0]);
    cover[group.row(i)] = 1;
    w.middleCols<size>(group.row(i)) *= r;
    natural /= r;
  });
  reset_steps();
}

void ScaledProblem::velocity(const Eigen::VectorXd& x, Eigen::VectorXd& g) const {
  g = b;
  g.noalias() += w * x;
}

double ScaledProblem::residual(const Eigen::VectorXd& x, const Eigen::VectorXd& g) const {
  double largest = 0;
  for_each_contact(*problem_, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    const double r = natural_[group.first_contact + i];
    const ContactVector<Domain> xi = group.segment(x, i);
    const ContactVector<Domain> y = xi - r * group.segment(g, i);
    largest = y.allFinite()
                  ? std::max(largest, (xi - project_contact(group.domain, group.mu[i], y)).norm() / r)
                  : std::numeric_limits<double>::infinity();
  });
  return believable(largest, rounding(x));
}

bool ScaledProblem::at_rounding(const Eigen::VectorXd& x, double residual) const {
  // The estimate is for one rounding where up to some dozens of products are added.
  constexpr double roundings = 8;
  return residual <= roundings * rounding(x);
}

double ScaledProblem::rounding(const Eigen::VectorXd& x) const {
  double largest = 1;
  for (Eigen::Index row = 0; row < rows(); ++row) {
    largest = std::max(largest, w.row(row).cwiseAbs().dot(x.cwiseAbs()));
  }
  for_each_contact(*problem_, [&](const auto& group, Eigen::Index i) {
    largest = std::max(largest, group.segment(x, i).norm() / natural_[group.first_contact + i]);
  });
  return std::numeric_limits<double>::epsilon() * largest;
}

void ScaledProblem::natural_map(const Eigen::VectorXd& x, const Eigen::VectorXd& g,
                                Eigen::VectorXd& h) const {
  for_each_contact(*problem_, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    const ContactVector<Domain> xi = group.segment(x, i);
    const ContactVector<Domain> y = xi - group.segment(step_, i).cwiseProduct(group.segment(g, i));
    if (y.allFinite()) {
      group.segment(h, i) = xi - project_contact(group.domain, group.mu[i], y);
    } else {
      group.segment(h, i).setConstant(std::numeric_limits<double>::infinity());
    }
  });
}

void ScaledProblem::natural_map(const Eigen::VectorXd& x, const Eigen::VectorXd& g, Eigen::VectorXd& h,
                                Eigen::MatrixXd& jacobian) const {
  const Eigen::Index n = rows();
  for_each_contact(*problem_, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    constexpr int size = TypedGroup<Domain>::rows;
    const Eigen::Index row = group.row(i);
    const ContactVector<Domain> xi = group.segment(x, i);
    const ContactVector<Domain> si = group.segment(step_, i);
    const ContactVector<Domain> y = xi - si.cwiseProduct(group.segment(g, i));
    if (!y.allFinite()) {
      group.segment(h, i).setConstant(std::numeric_limits<double>::infinity());
      jacobian.middleRows<size>(row).setZero();
      return;
    }
    ContactMatrix<Domain> d;
    group.segment(h, i) = xi - project_contact(group.domain, group.mu[i], y, d);
    const ContactMatrix<Domain> ds = d * si.asDiagonal();
    jacobian.block(row, 0, size, n).noalias() = ds * w.middleRows<size>(row);
    jacobian.block<size, size>(row, row) += ContactMatrix<Domain>::Identity() - d;
    if (jacobian.cols() > n) jacobian.col(n).segment<size>(row) = cover[row] * ds.col(0);
  });
}

void ScaledProblem::adapt_steps(const Eigen::VectorXd& x, const Eigen::VectorXd& g, double most) {
  for_each_contact(*problem_, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    if constexpr (Domain::dimension > 0) {
      using Vector = Eigen::Matrix<double, Domain::dimension, 1>;
      const Eigen::Index row = group.row(i);
      const double shortest = reset_step_[row + 1];
      const double pressed = x[row] - step_[row] * g[row];
      const Vector force = x.segment<Domain::dimension>(row + 1);
      const Vector slip = g.segment<Domain::dimension>(row + 1);
      const Vector y = force - shortest * slip;
      double step = shortest;
      if (pressed > 0 && y.allFinite() && !group.domain.contains(y, friction_size(group.mu[i], pressed))) {
        step = std::clamp(force.norm() / slip.norm(), shortest, most * shortest);
      }
      step_.segment<Domain::dimension>(row + 1).setConstant(step);
    }
  });
}

}  // namespace contensou
