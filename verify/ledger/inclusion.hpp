#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

/// What the rows of Section 4 are measured with: the friction ball of the Hertz law from its chord
/// integrals, and a contact problem (4.7) to (4.9) in generic numbers. None of it comes from the library.
namespace verify::ledger {

/// The ball of size μλ_N = 1; forces and velocities as (T1, T2, τ).
namespace hertz_ball {

/// Φ/(μλ_N), to 1e-12.
double support(const Eigen::Vector3d& gamma);
/// The border point with outward normal (v, s): −λ_F of the slip velocity with components v along T1 and s,
/// to 1e-12.
Eigen::Vector2d border(double v, double s);
/// The nearest point of the ball of that size, to 1e-12 of it: by bisection for the direction in which the
/// point is farthest above the supporting plane.
Eigen::Vector3d prox(const Eigen::Vector3d& x, double size);
/// Points that cover the border of the ball of size 1 with a mesh of the given number of steps in a right
/// angle.
std::vector<Eigen::Vector3d> cover(int steps);

}  // namespace hertz_ball

/// One contact of a body with six degrees of freedom.
struct Inclusion {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Eigen::Matrix<double, 6, 6> mass;
  Vector6 smooth;  ///< hΔt
  Vector6 before;  ///< u⁻
  Vector6 w_n;
  Eigen::Matrix<double, 6, 3> w_f;
  double mu;

  struct Point {
    Vector6 change;  ///< Δu
    double normal;   ///< Λ_N
    Eigen::Vector3d friction;
  };
  double gamma_n(const Vector6& change) const { return w_n.dot(before + change); }
  Eigen::Vector3d gamma_f(const Vector6& change) const { return w_f.transpose() * (before + change); }
  /// Δu of (4.7) for given impulses.
  Vector6 motion(double normal, const Eigen::Vector3d& friction) const;
  double largest_eigenvalue() const;  ///< of WᵀM⁻¹W
  /// Steps 1 and 2 of 4.1 with u⁻, repeated.
  Point iterate(double r, int times) const;
  /// The solution: r = 1/λ_max, until rounding.
  Point solve() const { return iterate(1 / largest_eigenvalue(), 3000); }

  /// (4.10); `size` of the ball as a function of the point.
  using Size = std::function<double(const Point&)>;
  double lagrangian(const Point& p, double r, const Size& size) const;
  /// Its derivative along `direction` by central differences with that step.
  double slope(const Point& p, const Point& direction, double r, const Size& size, double step) const;
};

/// A problem whose contact slides at the end of the step.
Inclusion sliding();
/// The same with so much friction that it sticks.
Inclusion sticking();

}  // namespace verify::ledger
