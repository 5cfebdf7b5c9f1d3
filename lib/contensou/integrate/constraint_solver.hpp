#pragma once

#include <Eigen/Core>
#include <vector>

namespace contensou {

/// Solves A x = b for the forces of constraints: A positive semi-definite and nearly symmetric, its rows and
/// columns of very different size (that of a torque is smaller than the others by (R/length)²), and dependent
/// where constraints repeat each other, or nothing that moves has a part in them (a zero row); b in its
/// range. Rows and columns are scaled by 1/√A_ii first; pivots below 1e-11 are then dependence: far above
/// rounding, far below the size of a patch. Of dependent constraints the forces x have least norm, so that
/// none is asked for more than it need bear.
///
/// Elimination with full pivoting; no allocation once systems stop growing.
class ConstraintSolver {
 public:
  /// For a system of m equations; `matrix` and `side` are then at least that large.
  void resize(Eigen::Index m);
  /// To be filled in by the caller after resize(): A and b; lost in solve().
  Eigen::MatrixXd matrix;
  Eigen::VectorXd side;

  /// x, the first m entries; valid until the next call.
  const Eigen::VectorXd& solve();

 private:
  Eigen::Index eliminate();
  void take_least_norm(Eigen::Index rank);

  Eigen::Index m_ = 0;
  Eigen::VectorXd scale_, solution_;
  Eigen::MatrixXd null_space_;
  std::vector<Eigen::Index> column_;
};

}  // namespace contensou
