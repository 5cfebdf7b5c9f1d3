#include "free_body.hpp"

#include <cmath>

namespace verify::answers::book {

Motion thrown() { return {inertia, omega}; }

double tilt(const Motion& motion, double t) {
  const Eigen::Vector3d axis = motion.attitude(t).col(2);
  return std::atan2(std::hypot(axis[0], axis[1]), axis[2]);
}

Whole whole(const Motion& motion, double t) {
  Whole all;
  const Eigen::Matrix3d axes = motion.attitude(t);
  all << axes * motion.omega(t) / omega.norm(), axes.col(0), axes.col(1), axes.col(2);
  return all;
}

double spread(const std::function<Whole(const Motion&)>& value) {
  const double step = 1e-7;
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d off = step * omega.norm() * Eigen::Vector3d::Unit(k);
    sum += (value(Motion(inertia, omega + off)) - value(Motion(inertia, omega - off))).norm() / (2 * step);
  }
  return sum;
}

}  // namespace verify::answers::book
