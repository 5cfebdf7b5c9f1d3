#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contensou/contact/contact_problem.hpp"

/// The tippe-top's contact problem on velocity level, written down from LG03 Section 5 for this study alone.
namespace verify::augmented {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Data of LG03 5.4, SI units. Index 0 is the body, 1 the tip.
struct TippeTop {
  double m = 6e-3;
  double i1 = 8e-7;
  double i3 = 7e-7;
  double g = 9.81;
  double a[2] = {0.3e-2, 1.6e-2};
  double r[2] = {1.5e-2, 0.5e-2};
  double mu = 0.3;

  Matrix6 mass(double theta) const;                     ///< (5.9)
  Vector6 force(double theta, const Vector6& u) const;  ///< h of (5.9)
  /// (W_N, W_T, W_τ) of contact i, (5.16), (5.20), (5.21) with φ = 0; without W_τ for radius = 0.
  Eigen::MatrixXd directions(int i, double theta, double radius) const;
  /// The inclination at which both contacts touch: g_N1 = g_N2 = 0 in (5.13), (5.14).
  double double_contact() const;
};

/// A state at the start of a step and which contacts are closed. u = (ẋ, ẏ, ż, θ̇, φ̇, ψ̇).
struct Case {
  std::string name;
  std::string motion;  ///< what happens in it
  double theta;
  Vector6 u;
  std::vector<int> closed;
  double radius = 5e-4;  ///< R [m]
};
std::vector<Case> cases();

/// A step of Δt = 1e-4 s: the data of (4.7) to (4.9), ε_N = 0, and the same in Delassus form.
struct Step {
  Matrix6 mass;
  Vector6 u;          ///< u⁻
  Vector6 smooth;     ///< hΔt
  Eigen::MatrixXd w;  ///< all directions, a column a row of the problem
  contensou::ContactProblem problem;
};
Step step(const TippeTop& top, const Case& c);

}  // namespace verify::augmented
