#include "contensou/integrate/classic_rk4.hpp"

#include <limits>

namespace contensou {

double ClassicRk4::attempt(OdeSystem& system, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                           double h, const Eigen::VectorXd& /*scale*/) {
  if (start_.size() != y.size()) {
    for (Eigen::VectorXd* v : {&start_, &end_, &end_rate_, &argument_}) v->resize(y.size());
    for (Eigen::VectorXd& k : k_) k.resize(y.size());
  }
  h_ = h;
  start_ = y;
  k_[0] = rate;
  argument_ = start_ + h / 2 * k_[0];
  system.derivative(t + h / 2, argument_, k_[1]);
  argument_ = start_ + h / 2 * k_[1];
  system.derivative(t + h / 2, argument_, k_[2]);
  argument_ = start_ + h * k_[2];
  system.derivative(t + h, argument_, k_[3]);
  argument_ = start_ + h / 6 * (k_[0] + 2 * (k_[1] + k_[2]) + k_[3]);
  if (!argument_.allFinite()) return std::numeric_limits<double>::infinity();
  system.derivative(t + h, argument_, k_[3]);
  if (!k_[3].allFinite()) return std::numeric_limits<double>::infinity();
  end_.swap(argument_);
  end_rate_.swap(k_[3]);
  return 0;
}

void ClassicRk4::interpolate(OdeSystem& /*system*/, double theta, Eigen::VectorXd& y) {
  const double rest = 1 - theta;
  y = rest * start_ + theta * end_ +
      theta * rest * (rest * h_ * k_[0] - theta * h_ * end_rate_ - (1 - 2 * theta) * (end_ - start_));
}

}  // namespace contensou
