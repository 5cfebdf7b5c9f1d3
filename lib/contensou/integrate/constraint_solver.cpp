#include "contensou/integrate/constraint_solver.hpp"

#include <cmath>
#include <numeric>
#include <utility>

namespace contensou {
namespace {

constexpr double dependent = 1e-11;

}  // namespace

void ConstraintSolver::resize(Eigen::Index m) {
  m_ = m;
  if (matrix.rows() >= m) return;
  for (Eigen::MatrixXd* a : {&matrix, &null_space_}) a->resize(m, m);
  for (Eigen::VectorXd* v : {&side, &scale_, &solution_}) v->resize(m);
  column_.resize(static_cast<std::size_t>(m));
}

/// P A Q = L U with L and U in place and P b, L⁻¹ applied, in `side`; returns the rank. column_ is Q.
Eigen::Index ConstraintSolver::eliminate() {
  std::iota(column_.begin(), column_.end(), Eigen::Index{0});
  for (Eigen::Index k = 0; k < m_; ++k) {
    Eigen::Index i = k, j = k;
    for (Eigen::Index c = k; c < m_; ++c) {
      for (Eigen::Index r = k; r < m_; ++r) {
        if (!(std::abs(matrix(r, c)) > std::abs(matrix(i, j)))) continue;
        i = r;
        j = c;
      }
    }
    if (std::abs(matrix(i, j)) <= dependent) return k;
    if (i != k) {
      for (Eigen::Index c = 0; c < m_; ++c) std::swap(matrix(i, c), matrix(k, c));
      std::swap(side[i], side[k]);
    }
    if (j != k) {
      for (Eigen::Index r = 0; r < m_; ++r) std::swap(matrix(r, j), matrix(r, k));
      std::swap(column_[static_cast<std::size_t>(j)], column_[static_cast<std::size_t>(k)]);
    }
    for (Eigen::Index r = k + 1; r < m_; ++r) {
      const double factor = matrix(r, k) / matrix(k, k);
      for (Eigen::Index c = k + 1; c < m_; ++c) matrix(r, c) -= factor * matrix(k, c);
      side[r] -= factor * side[k];
    }
  }
  return m_;
}

/// Takes out of the solution, in which the dependent unknowns are zero, its part in the null space.
void ConstraintSolver::take_least_norm(Eigen::Index rank) {
  for (Eigen::Index n = rank; n < m_; ++n) {
    // One unknown is 1, the independent ones follow; in units of x.
    auto v = null_space_.col(n);
    for (Eigen::Index k = 0; k < m_; ++k) v[k] = k == n ? 1 : 0;
    for (Eigen::Index k = rank - 1; k >= 0; --k) {
      double sum = -matrix(k, n);
      for (Eigen::Index c = k + 1; c < rank; ++c) sum -= matrix(k, c) * v[c];
      v[k] = sum / matrix(k, k);
    }
    for (Eigen::Index k = 0; k < m_; ++k) side[k] = v[k];
    for (Eigen::Index k = 0; k < m_; ++k) {
      const Eigen::Index j = column_[static_cast<std::size_t>(k)];
      v[j] = side[k] * scale_[j];
    }
    for (Eigen::Index other = rank; other < n; ++other) {
      const double part = v.head(m_).dot(null_space_.col(other).head(m_));
      v.head(m_) -= part * null_space_.col(other).head(m_);
    }
    v.head(m_) /= v.head(m_).norm();
    solution_.head(m_) -= v.head(m_).dot(solution_.head(m_)) * v.head(m_);
  }
}

const Eigen::VectorXd& ConstraintSolver::solve() {
  if (m_ == 1) {
    solution_[0] = side[0] / matrix(0, 0);
    return solution_;
  }
  for (Eigen::Index i = 0; i < m_; ++i)
    scale_[i] = matrix(i, i) == 0 ? 1 : 1 / std::sqrt(std::abs(matrix(i, i)));
  for (Eigen::Index j = 0; j < m_; ++j) {
    for (Eigen::Index i = 0; i < m_; ++i) matrix(i, j) *= scale_[i] * scale_[j];
    side[j] *= scale_[j];
  }
  const Eigen::Index rank = eliminate();
  for (Eigen::Index k = m_ - 1; k >= 0; --k) {
    const auto j = column_[static_cast<std::size_t>(k)];
    if (k >= rank) {
      side[k] = 0;
    } else {
      for (Eigen::Index c = k + 1; c < rank; ++c) side[k] -= matrix(k, c) * side[c];
      side[k] /= matrix(k, k);
    }
    solution_[j] = side[k] * scale_[j];
  }
  if (rank < m_) take_least_norm(rank);
  return solution_;
}

}  // namespace contensou
