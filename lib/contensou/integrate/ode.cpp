#include "contensou/integrate/ode.hpp"

#include <cmath>
#include <limits>

namespace contensou {

void OdeSystem::jacobian(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                         Eigen::MatrixXd& jacobian) {
  // Half of the digits for the difference, half for its error.
  static const double increment = std::sqrt(std::numeric_limits<double>::epsilon());
  Eigen::VectorXd moved = y;
  Eigen::VectorXd moved_rate(size());
  for (Eigen::Index j = 0; j < coupled(); ++j) {
    moved[j] = y[j] + increment * (1 + std::abs(y[j]));
    derivative(t, moved, moved_rate);
    jacobian.col(j) = (moved_rate - rate) / (moved[j] - y[j]);
    moved[j] = y[j];
  }
}

}  // namespace contensou
