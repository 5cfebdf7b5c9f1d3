#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "contensou/contact/scaled_problem.hpp"

namespace contensou {

/// What follow_covering_path keeps from one problem to the next.
struct CoveringPathMemory {
  Eigen::VectorXd point, tangent, predicted, trial, right, correction;  ///< (x, z)
  Eigen::VectorXd x, velocity, map, diagonal;
  Eigen::MatrixXd jacobian, bordered;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
  Eigen::VectorXi order;  ///< of lu's rows
};

struct CoveringPathOptions {
  double regularisation;  ///< relative increase of w's diagonal, which makes x unique and bounded on the way
  double largest_step;    ///< of ScaledProblem::adapt_steps
  int most_steps;
};

/// Follows the solutions x(z) of the problem with z cover added to the velocities, z >= 0, from a z so large
/// that all contacts are open, x = 0, to z = 0: Lemke's method for problems that are not piecewise linear, by
/// pseudo-arclength continuation. For z > 0 the problem has solutions whatever μ (see random_problems.hpp for
/// the criterion), W being positive semi-definite, so the path cannot end before z = 0; it may turn back in z
/// on the way, and does at corners, where contacts change state. The tangent is oriented by the sign of the
/// determinant of the Jacobian bordered by it, which stays the same in all pieces.
///
/// memory.x is the last point reached, also where it is not z = 0. Returns the number of steps taken.
int follow_covering_path(ScaledProblem& problem, const CoveringPathOptions& options,
                         CoveringPathMemory& memory);

}  // namespace contensou
