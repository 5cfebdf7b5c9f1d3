#pragma once

#include <Eigen/Core>

namespace contensou {

/// Anderson's acceleration of a fixed-point iteration x ← g(x) (D.G. Anderson, J. ACM 12, 1965): of the
/// last `depth` changes of f = g(x) − x, the combination for which f would be least if it were affine.
class Anderson {
 public:
  static constexpr int depth = 5;

  /// Forgets what was; n unknowns. Allocates only where n is larger than ever.
  void restart(Eigen::Index n);
  /// The next x from g(x), where x is what the last step returned or the first one, of n or more entries.
  void step(const Eigen::VectorXd& g, Eigen::VectorXd& x);
  /// ‖g(x) − x‖ of the last step.
  double size() const { return size_; }

 private:
  Eigen::Index n_ = 0;
  int count_ = 0;  ///< changes kept
  int next_ = 0;   ///< where the next one goes
  bool first_ = true;
  double size_ = 0;
  Eigen::MatrixXd changes_f_, changes_g_;
  Eigen::VectorXd f_, last_f_, last_g_;
  Eigen::Matrix<double, depth, depth> gram_;  ///< of changes_f_
};

}  // namespace contensou
