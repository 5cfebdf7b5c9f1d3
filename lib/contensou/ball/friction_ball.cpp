#include "contensou/ball/friction_ball.hpp"

namespace contensou::detail {

Cylindrical cylindrical(const Eigen::Vector3d& x) {
  const double x1 = x[0];
  const double x2 = x[1];
  const double tau = std::abs(x[2]);
  const double square = x1 * x1 + x2 * x2;
  // Between these the squares of the larger component are as accurate as normal doubles are.
  constexpr double smallest = 0x1p-900;
  constexpr double largest = 0x1p1000;
  double t = 0;
  if (square > smallest && square < largest) {
    t = std::sqrt(square);
  } else {
    t = std::hypot(x1, x2);
  }
  if (!(std::isfinite(x1) && std::isfinite(x2) && std::isfinite(tau))) {
    throw std::domain_error("friction ball: a force or velocity is not finite");
  }
  const double sign = std::signbit(x[2]) ? -1.0 : 1.0;
  if (t == 0) return {{0, tau}, 1, 0, sign};
  if (std::isinf(t))
    t = std::numeric_limits<double>::max();  // up to √2 too small: only its direction is felt
  return {{t, tau}, x1 / t, x2 / t, sign};
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
  return along * tangent * tangent.transpose() + across * around * around.transpose();
}

}  // namespace contensou::detail
