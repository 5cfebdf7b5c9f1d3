#include "contensou/contact/impact_law.hpp"

#include <stdexcept>
#include <string>

#include "contensou/contact/blocks.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

[[noreturn]] void fail(const std::string& what) { throw std::invalid_argument("impact: " + what); }

template <class Matrix>
void require(const char* name, const Matrix& x, Eigen::Index rows, Eigen::Index columns) {
  if (x.rows() != rows || x.cols() != columns) {
    fail(std::string(name) + " is " + std::to_string(x.rows()) + " x " + std::to_string(x.cols()) +
         ", expected " + std::to_string(rows) + " x " + std::to_string(columns));
  }
  if (!x.allFinite()) fail(std::string(name) + " has an entry that is not finite");
}

void require_valid(const ImpactStep& step, const ContactProblem& problem) {
  require_valid_groups(problem);
  const Eigen::Index f = step.velocity.size();
  const Eigen::Index n = problem.rows();
  const auto contacts = static_cast<Eigen::Index>(problem.contacts());
  require("velocity", step.velocity, f, 1);
  require("inverse_mass", step.inverse_mass, f, f);
  require("directions", step.directions, f, n);
  require("smooth_change", step.smooth_change, f, 1);
  require("drive", step.drive, n, 1);
  require("restitution", step.restitution, contacts, 1);
  for (Eigen::Index i = 0; i < contacts; ++i) {
    if (step.restitution[i] >= 0 && step.restitution[i] <= 1) continue;
    fail("restitution[" + std::to_string(i) + "] = " + to_text(step.restitution[i]) + ", expected 0 to 1");
  }
}

}  // namespace

void assemble_impact(const ImpactStep& step, Eigen::MatrixXd& response, ContactProblem& problem) {
  require_valid(step, problem);
  response.resizeLike(step.directions);
  response.noalias() = step.inverse_mass * step.directions;
  const Eigen::Index n = problem.rows();
  problem.delassus.resize(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = j; i < n; ++i) {
      problem.delassus(i, j) = step.directions.col(i).dot(response.col(j));
      problem.delassus(j, i) = problem.delassus(i, j);
    }
  }
  problem.free_velocity.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto w = step.directions.col(i);
    problem.free_velocity[i] = w.dot(step.velocity) + w.dot(step.smooth_change) + step.drive[i];
  }
  for_each_contact(problem, [&](const auto& group, Eigen::Index i) {
    const Eigen::Index normal = group.row(i);
    const double before = step.directions.col(normal).dot(step.velocity) + step.drive[normal];
    problem.free_velocity[normal] += step.restitution[group.first_contact + i] * before;
  });
}

Eigen::VectorXd velocity_after(const ImpactStep& step, const Eigen::MatrixXd& response,
                               const Eigen::VectorXd& impulse) {
  return step.velocity + step.smooth_change + response * impulse;
}

}  // namespace contensou
