#pragma once

#include <Eigen/Cholesky>

#include "tippe_top.hpp"

/// The iteration of LG03 4.1 in its own variables, Δu and Λ; step 1 solves with M.
namespace verify::augmented {

/// What step 2 adds to Δu^{k+1}, printed as u^k.
enum class Reading {
  before,      ///< u⁻, as in (4.9)
  iterate,     ///< u^k = u⁻ + Δu^k, the last iterate
  accumulate,  ///< u^k = u^{k−1} + Δu^k, as a Newton update would have it
};

/// Impulses, and after each pass how far they moved as 4.1 measures it.
struct Pass {
  Eigen::VectorXd impulse;
  double change;  ///< ‖ΔΛ_N‖ + ‖ΔΛ_F‖, the norms over all contacts
};

class Iteration {
 public:
  Iteration(const Step& step, double r, Reading reading = Reading::before);
  /// Steps 1 and 2 once.
  Pass advance();

 private:
  const Step& step_;
  double r_;
  Reading reading_;
  Eigen::LDLT<Matrix6> mass_;
  Eigen::VectorXd impulse_;
  Vector6 u_;  ///< u^k
};

/// Π(Λ − rγ) of (4.16) with footnote 1, all contacts, one r.
Eigen::VectorXd project(const Step& step, const Eigen::VectorXd& impulse, const Eigen::VectorXd& velocity,
                        double r);

/// The spectral radius of the iteration's derivative at Λ, by central differences: its rate of convergence
/// where it converges to Λ. Modes that stand still (impulses that move nothing, W of lower rank) do not
/// count.
double spectral_radius(const Step& step, const Eigen::VectorXd& impulse, double r);

}  // namespace verify::augmented
