#include "contensou/ball/friction_ball.hpp"

namespace contensou::detail {

Cylindrical cylindrical(const Eigen::Vector3d& x) {
  const double tau = std::abs(x[2]);
  const double sign = std::signbit(x[2]) ? -1.0 : 1.0;
  const double square = x[0] * x[0] + x[1] * x[1];
  // Between these the squares of the larger component are as accurate as normal doubles are.
  constexpr double smallest = 0x1p-900;
  constexpr double largest = 0x1p1000;
  if (square > smallest && square < largest && std::isfinite(tau)) {
    const double t = std::sqrt(square);
    return {{t, tau}, x[0] / t, x[1] / t, sign};
  }
  if (!x.allFinite()) throw std::domain_error("friction ball: a force or velocity is not finite");
  if (x[0] == 0 && x[1] == 0) return {{0, tau}, 1, 0, sign};
  const int exponent = exponent_of({std::abs(x[0]), std::abs(x[1])});
  const double x1 = std::ldexp(x[0], -exponent);
  const double x2 = std::ldexp(x[1], -exponent);
  const double t = std::sqrt(x1 * x1 + x2 * x2);
  // Up to √2 too small at the very end of the range, where only its direction is felt.
  const double length = std::min(std::ldexp(t, exponent), std::numeric_limits<double>::max());
  return {{length, tau}, x1 / t, x2 / t, sign};
}

int exponent_of(Meridian p) {
  int exponent = 0;
  std::frexp(std::max(p.t, p.tau), &exponent);
  return exponent;
}

void require_size(double size) {
  if (!(size >= 0 && std::isfinite(size))) {
    throw std::invalid_argument("friction ball: its size mu*lambda_N must be a finite number >= 0");
  }
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
