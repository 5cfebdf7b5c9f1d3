#include "contensou/integrate/constraint_solver.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace contensou {
namespace {

constexpr double dependent = 1e-11;

}  // namespace

void ConstraintSolver::resize(Eigen::Index m) {
  if (matrix.rows() == m) return;
  matrix.resize(m, m);
  eliminated_.resize(m, m);
  for (Eigen::VectorXd* v : {&side, &scale_, &solution_}) v->resize(m);
  column_.resize(static_cast<std::size_t>(m));
}

const Eigen::VectorXd& ConstraintSolver::solve() {
  const Eigen::Index m = matrix.rows();
  if (m == 1) {
    solution_[0] = side[0] / matrix(0, 0);
    return solution_;
  }
  for (Eigen::Index i = 0; i < m; ++i) scale_[i] = 1 / std::sqrt(std::abs(matrix(i, i)));
  for (Eigen::Index j = 0; j < m; ++j) {
    for (Eigen::Index i = 0; i < m; ++i) matrix(i, j) *= scale_[i] * scale_[j];
  }
  side.array() *= scale_.array();
  eliminated_ = matrix;
  solution_ = side;
  std::iota(column_.begin(), column_.end(), Eigen::Index{0});
  for (Eigen::Index k = 0; k < m; ++k) {
    Eigen::Index i = 0, j = 0;
    const double pivot = eliminated_.bottomRightCorner(m - k, m - k).cwiseAbs().maxCoeff(&i, &j);
    if (!(pivot > dependent)) {
      if (!matrix.allFinite()) {
        solution_.setConstant(std::nan(""));
        return solution_;
      }
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition(m, m);
      decomposition.setThreshold(dependent);
      decomposition.compute(matrix);
      solution_ = decomposition.solve(side);
      solution_.array() *= scale_.array();
      return solution_;
    }
    i += k;
    j += k;
    if (i != k) {
      eliminated_.row(i).swap(eliminated_.row(k));
      std::swap(solution_[i], solution_[k]);
    }
    if (j != k) {
      eliminated_.col(j).swap(eliminated_.col(k));
      std::swap(column_[static_cast<std::size_t>(j)], column_[static_cast<std::size_t>(k)]);
    }
    for (Eigen::Index r = k + 1; r < m; ++r) {
      const double factor = eliminated_(r, k) / eliminated_(k, k);
      for (Eigen::Index c = k + 1; c < m; ++c) eliminated_(r, c) -= factor * eliminated_(k, c);
      solution_[r] -= factor * solution_[k];
    }
  }
  for (Eigen::Index k = m - 1; k >= 0; --k) {
    for (Eigen::Index c = k + 1; c < m; ++c) solution_[k] -= eliminated_(k, c) * solution_[c];
    solution_[k] /= eliminated_(k, k);
  }
  // Back to the order of the columns; `side` is no longer needed.
  for (Eigen::Index k = 0; k < m; ++k) {
    const Eigen::Index j = column_[static_cast<std::size_t>(k)];
    side[j] = solution_[k] * scale_[j];
  }
  solution_.swap(side);
  return solution_;
}

}  // namespace contensou
