#include "contensou/ball/friction_ball.hpp"

#include <stdexcept>

namespace contensou::detail {

Cylindrical cylindrical(const Eigen::Vector3d& x) {
  if (!std::isfinite(x[2])) not_finite(ball_name);
  const Polar p = polar(x[0], x[1], ball_name);
  return {{p.length(), std::abs(x[2])}, p.e1, p.e2, std::signbit(x[2]) ? -1.0 : 1.0};
}

int exponent_of(Meridian p) {
  int exponent = 0;
  std::frexp(std::max(p.t, p.tau), &exponent);
  return exponent;
}

void no_direction() { throw std::domain_error("friction ball: a zero vector has no direction"); }

Eigen::Matrix3d projection_jacobian(const Cylindrical& frame, Meridian unit_normal, double along,
                                    double across) {
  const Eigen::Vector3d tangent = frame.vector({unit_normal.tau, -unit_normal.t});
  const Eigen::Vector3d around(-frame.e2, frame.e1, 0);
  // Evaluated first, so that the sum is symmetric to the bit.
  const Eigen::Matrix3d along_part = tangent * tangent.transpose();
  const Eigen::Matrix3d around_part = around * around.transpose();
  return along * along_part + across * around_part;
}

}  // namespace contensou::detail
