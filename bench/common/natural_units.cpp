#include "natural_units.hpp"

#include <cmath>

namespace bench {

contensou::ContactProblem in_natural_units(const contensou::ContactProblem& problem) {
  const Eigen::MatrixXd& w = problem.delassus;
  Eigen::VectorXd unit(problem.rows());
  Eigen::Index row = 0;
  for (const contensou::ContactGroup& group : problem.groups) {
    const Eigen::Index rows = contensou::rows(*group.friction);
    for (std::size_t i = 0; i < group.mu.size(); ++i, row += rows) {
      const double norm = w.block(row, row, rows, rows).cwiseAbs().rowwise().sum().maxCoeff();
      unit.segment(row, rows).setConstant(norm > 0 ? 1 / std::sqrt(norm) : 1);
    }
  }
  contensou::ContactProblem scaled{problem.groups, unit.asDiagonal() * w * unit.asDiagonal(),
                                   unit.cwiseProduct(problem.free_velocity)};
  scaled.free_velocity /= scaled.free_velocity.cwiseAbs().maxCoeff();
  return scaled;
}

}  // namespace bench
