#include "contensou/contact/contact_problem.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "contensou/contact/blocks.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

[[noreturn]] void fail(const std::string& what) { throw std::invalid_argument("contact problem: " + what); }

std::string size_text(Eigen::Index rows, Eigen::Index columns) {
  return std::to_string(rows) + " x " + std::to_string(columns);
}

void require_coefficients(const ContactGroup& group, std::size_t index) {
  const std::string name = "group " + std::to_string(index);
  if (group.friction == nullptr) fail(name + " has no friction, not even NoFriction");
  if (std::holds_alternative<NoFriction>(*group.friction)) return;
  for (std::size_t i = 0; i < group.mu.size(); ++i) {
    if (group.mu[i] >= 0 && std::isfinite(group.mu[i])) continue;
    fail(name + ", contact " + std::to_string(i) + ": mu = " + to_text(group.mu[i]) +
         ", expected a finite number >= 0");
  }
}

[[noreturn]] void fail_at_entry(const ContactProblem& problem) {
  for (Eigen::Index i = 0; i < problem.free_velocity.size(); ++i) {
    if (std::isfinite(problem.free_velocity[i])) continue;
    fail("free_velocity[" + std::to_string(i) + "] = " + to_text(problem.free_velocity[i]) +
         ", expected a finite number");
  }
  Eigen::Index row = 0;
  Eigen::Index column = 0;
  while (std::isfinite(problem.delassus(row, column))) {
    if (++row == problem.delassus.rows()) row = 0, ++column;
  }
  fail("delassus(" + std::to_string(row) + ", " + std::to_string(column) +
       ") = " + to_text(problem.delassus(row, column)) + ", expected a finite number");
}

}  // namespace

int rows(const AnyFriction& friction) {
  return std::visit([]<class Domain>(const Domain&) { return 1 + Domain::dimension; }, friction);
}

std::size_t ContactProblem::contacts() const {
  std::size_t count = 0;
  for (const ContactGroup& group : groups) count += group.mu.size();
  return count;
}

Eigen::Index ContactProblem::rows() const {
  Eigen::Index count = 0;
  for (const ContactGroup& group : groups) {
    count += contensou::rows(*group.friction) * static_cast<Eigen::Index>(group.mu.size());
  }
  return count;
}

void require_valid_groups(const ContactProblem& problem) {
  for (std::size_t i = 0; i < problem.groups.size(); ++i) require_coefficients(problem.groups[i], i);
}

void require_valid(const ContactProblem& problem) {
  require_valid_groups(problem);
  const Eigen::Index n = problem.rows();
  if (problem.delassus.rows() != n || problem.delassus.cols() != n) {
    fail("delassus is " + size_text(problem.delassus.rows(), problem.delassus.cols()) + ", expected " +
         size_text(n, n));
  }
  if (problem.free_velocity.size() != n) {
    fail("free_velocity has " + std::to_string(problem.free_velocity.size()) + " rows, expected " +
         std::to_string(n));
  }
  if (!problem.free_velocity.allFinite() || !problem.delassus.allFinite()) fail_at_entry(problem);
}

void natural_steps(const ContactProblem& problem, Eigen::VectorXd& step) {
  step.resize(static_cast<Eigen::Index>(problem.contacts()));
  double largest = 0;
  for_each_contact(problem, [&](const auto& group, Eigen::Index i) {
    const double norm = row_sum_norm(group.block(problem.delassus, i));
    step[group.first_contact + i] = norm;
    largest = std::max(largest, norm);
  });
  const double fallback = natural_step(largest, 1);
  for (double& r : step) r = natural_step(r, fallback);
}

void certified_velocity(const ContactProblem& problem, const Eigen::VectorXd& impulse,
                        Eigen::VectorXd& velocity) {
  for (Eigen::Index i = 0; i < impulse.size(); ++i) {
    long double sum = problem.free_velocity[i];
    for (Eigen::Index j = 0; j < impulse.size(); ++j) {
      sum += static_cast<long double>(problem.delassus(i, j)) * impulse[j];
    }
    velocity[i] = static_cast<double>(sum);
  }
}

double natural_map_residual(const ContactProblem& problem, const Eigen::VectorXd& impulse,
                            const Eigen::VectorXd& velocity, const Eigen::VectorXd& step) {
  if (impulse.size() == 0) return 0;
  const double largest = problem.free_velocity.lpNorm<Eigen::Infinity>();
  double residual = 0;
  for_each_contact(problem, [&]<class Domain>(const TypedGroup<Domain>& group, Eigen::Index i) {
    const ContactVector<Domain> lambda = group.segment(impulse, i);
    const ContactVector<Domain> gamma = group.segment(velocity, i);
    const double r = step[group.first_contact + i];
    residual =
        std::max(residual, contact_residual<Domain>(group.domain, group.mu[i], lambda, gamma, r, largest));
  });
  return residual;
}

double natural_map_residual(const ContactProblem& problem, const Eigen::VectorXd& impulse) {
  Eigen::VectorXd step;
  natural_steps(problem, step);
  Eigen::VectorXd velocity(problem.rows());
  certified_velocity(problem, impulse, velocity);
  return natural_map_residual(problem, impulse, velocity, step);
}

}  // namespace contensou
