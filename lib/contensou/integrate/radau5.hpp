#pragma once

#include <Eigen/LU>
#include <array>
#include <complex>

#include "contensou/integrate/ode.hpp"

namespace contensou {

/// The implicit Runge–Kutta method Radau IIA of order 5 (E. Hairer, G. Wanner, Solving Ordinary Differential
/// Equations II, 2nd ed., Springer 1996, Section IV.8): L-stable, its last stage is the end of the step. For
/// phases in which an explicit method would have to follow a rate of relaxation far faster than the motion.
///
/// A step evaluates the Jacobian once and solves for the stages by simplified Newton iterations in the
/// transformed variables of IV.8; it returns infinity where these do not converge, so that the step is tried
/// smaller. The estimate is that of IV.8 (against a formula of order 3) and goes like h⁴; the continuous
/// extension is the collocation polynomial, of order 3. Quadratures, components from coupled() on, cost
/// nothing in the linear algebra.
class Radau5 final : public OdeStep {
 public:
  double attempt(OdeSystem& system, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate, double h,
                 const Eigen::VectorXd& scale) override;
  const Eigen::VectorXd& end() const override { return end_; }
  const Eigen::VectorXd& end_rate() const override { return end_rate_; }
  void interpolate(OdeSystem& system, double theta, Eigen::VectorXd& y) override;
  int error_order() const override { return 4; }

 private:
  void resize(Eigen::Index size, Eigen::Index coupled);
  bool solve_stages(OdeSystem& system, double t, double h, const Eigen::VectorXd& scale);
  double estimate(OdeSystem& system, double t, double h, const Eigen::VectorXd& rate,
                  const Eigen::VectorXd& scale);

  Eigen::VectorXd start_, start_rate_, end_, end_rate_;
  Eigen::MatrixXd jacobian_;
  Eigen::MatrixXd real_matrix_;
  Eigen::MatrixXcd complex_matrix_;
  Eigen::PartialPivLU<Eigen::MatrixXd> real_;
  Eigen::PartialPivLU<Eigen::MatrixXcd> complex_;
  std::array<Eigen::VectorXd, 3> z_;  ///< stages less the start
  std::array<Eigen::VectorXd, 3> k_;  ///< f at the stages
  std::array<Eigen::VectorXd, 3> w_;  ///< z, transformed
  Eigen::VectorXd argument_, real_side_, real_change_, error_;
  Eigen::VectorXcd complex_side_, complex_change_;
};

}  // namespace contensou
