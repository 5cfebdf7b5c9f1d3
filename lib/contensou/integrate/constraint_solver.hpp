#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

namespace contensou {

/// Solves A x = b for the forces of constraints: A positive semi-definite and nearly symmetric, its rows and
/// columns of very different size (that of a torque is smaller than the others by (R/length)²), and dependent
/// where constraints repeat each other; b in its range. Rows and columns are scaled by 1/√A_ii first; pivots
/// below 1e-11 are then dependence: far above rounding, far below the size of a patch. Of dependent
/// constraints the scaled forces have least norm.
///
/// Elimination with full pivoting in memory of its own; only where constraints are dependent does it allocate.
class ConstraintSolver {
 public:
  /// To be filled in by the caller, after resize(): A (destroyed) and b.
  Eigen::MatrixXd matrix;
  Eigen::VectorXd side;

  void resize(Eigen::Index m);
  /// x, not a number where A is not finite; valid until the next call.
  const Eigen::VectorXd& solve();

 private:
  Eigen::VectorXd scale_, solution_;
  Eigen::MatrixXd eliminated_;
  std::vector<Eigen::Index> column_;
};

}  // namespace contensou
