#pragma once

#include <array>

#include "contensou/integrate/ode.hpp"

namespace contensou {

/// The classical Runge–Kutta method of order 4, LG03 (4.20) with its Butcher array. No error estimate; the
/// continuous extension is Hermite's cubic (local error O(h⁴)).
class ClassicRk4 final : public OdeStep {
 public:
  double attempt(OdeSystem& system, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate, double h,
                 const Eigen::VectorXd& scale) override;
  const Eigen::VectorXd& end() const override { return end_; }
  const Eigen::VectorXd& end_rate() const override { return end_rate_; }
  void interpolate(OdeSystem& system, double theta, Eigen::VectorXd& y) override;
  int error_order() const override { return 5; }

 private:
  double h_ = 0;
  Eigen::VectorXd start_, end_, end_rate_, argument_;
  std::array<Eigen::VectorXd, 4> k_;
};

}  // namespace contensou
