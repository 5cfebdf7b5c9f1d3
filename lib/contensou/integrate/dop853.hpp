#pragma once

#include <array>

#include "contensou/integrate/dop853_coefficients.hpp"
#include "contensou/integrate/ode.hpp"

namespace contensou {

/// The explicit Runge–Kutta method of order 8 of Dormand and Prince with the error estimate and the
/// continuous extension of Hairer, Nørsett and Wanner (coefficients: dop853_coefficients.hpp). A step costs
/// 12 evaluations, the last of which is the next step's first; the extension, of order 7 (local error O(h⁸)),
/// costs 3 more, when first asked for. The estimate combines differences to results of orders 5 and 3 and
/// goes like h⁸.
///
/// `y` and `rate` of an attempt may be this object's own end() and end_rate(). After an attempt that returned
/// infinity there is nothing to interpolate.
class Dop853 final : public OdeStep {
 public:
  double attempt(OdeSystem& system, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate, double h,
                 const Eigen::VectorXd& scale) override;
  const Eigen::VectorXd& end() const override { return end_; }
  const Eigen::VectorXd& end_rate() const override { return end_rate_; }
  void interpolate(OdeSystem& system, double theta, Eigen::VectorXd& y) override;
  int error_order() const override { return 8; }

 private:
  void resize(Eigen::Index n);
  template <std::size_t S>
  void evaluate_stage(OdeSystem& system);
  double error_norm(const Eigen::VectorXd& scale) const;
  void extend(OdeSystem& system);

  double t_ = 0;
  double h_ = 0;
  Eigen::VectorXd start_;
  Eigen::VectorXd end_;
  Eigen::VectorXd end_rate_;
  std::array<Eigen::VectorXd, dop853::stages> k_;  ///< f at the stages
  Eigen::VectorXd argument_;                       ///< y of the stage at hand
  Eigen::VectorXd slope_;                          ///< (y at the end less y at the start)/h
  Eigen::VectorXd error5_, error3_;                ///< differences of slopes
  bool extended_ = false;
  std::array<Eigen::VectorXd, 7> extension_;
};

}  // namespace contensou
