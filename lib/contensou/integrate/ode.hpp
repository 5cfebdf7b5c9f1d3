#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace contensou {

/// ẏ = f(t, y) between events. The last components may be quadratures: f does not depend on them.
class OdeSystem {
 public:
  virtual ~OdeSystem() = default;
  virtual Eigen::Index size() const = 0;
  /// The number of leading components that f depends on; the others are quadratures.
  virtual Eigen::Index coupled() const { return size(); }
  /// f(t, y) into dy (size()). Counted by whoever implements it. May write numbers that are not finite: the
  /// step is then rejected.
  virtual void derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) = 0;
  /// ∂f/∂y at (t, y), rows size(), columns coupled(), for implicit methods; `rate` is f(t, y). By forward
  /// differences where not overridden. `jacobian` has the right size.
  virtual void jacobian(double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                        Eigen::MatrixXd& jacobian);
};

/// One step of a one-step method and what can be asked of it afterwards. Allocates at the first attempt for a
/// system of another size only.
class OdeStep {
 public:
  virtual ~OdeStep() = default;

  /// Tries the step from (t, y) to t + h; `rate` is f(t, y). Returns the estimated local error as the root
  /// mean square of error_i/scale_i over all components: acceptable if <= 1; infinite if the step could not
  /// be computed (not finite, an iteration that does not converge). Methods without an estimate return 0.
  virtual double attempt(OdeSystem& system, double t, const Eigen::VectorXd& y, const Eigen::VectorXd& rate,
                         double h, const Eigen::VectorXd& scale) = 0;
  /// y and f at t + h of the last attempt that did not return infinity; f was evaluated last of all there.
  virtual const Eigen::VectorXd& end() const = 0;
  virtual const Eigen::VectorXd& end_rate() const = 0;
  /// y at t + θh, 0 <= θ <= 1, continuous, of an order stated with the method. May evaluate f when asked for
  /// the first time after an attempt.
  virtual void interpolate(OdeSystem& system, double theta, Eigen::VectorXd& y) = 0;
  /// The estimated error grows like h^(error_order()).
  virtual int error_order() const = 0;
};

}  // namespace contensou
