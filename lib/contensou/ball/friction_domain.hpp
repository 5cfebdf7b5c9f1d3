#pragma once

#include <Eigen/Core>
#include <concepts>

namespace contensou {

/// The Euclidean projection of a force onto a domain, in the units of the force.
template <int dimension>
struct Projection {
  using Vector = Eigen::Matrix<double, dimension, 1>;
  Vector point;     ///< nearest point of the domain; the force itself where it is inside
  Vector normal;    ///< unit outward normal at `point`; zero where the force is inside
  double distance;  ///< from the domain; 0 inside
  double residual;  ///< length of what is left of (force − point) beside the normal; 0 inside
  int iterations;   ///< points of the border evaluated; 0 where the projection is in closed form
  bool inside;
};

/// An element of the generalised Jacobian (Clarke) of the projection as a function of force and size.
template <int dimension>
struct ProjectionDerivative {
  using Matrix = Eigen::Matrix<double, dimension, dimension>;
  using Vector = Eigen::Matrix<double, dimension, 1>;
  Matrix force;  ///< symmetric, eigenvalues in [0, 1] for a convex domain
  Vector size;   ///< (I − force) point/size; zero inside
};

/// The admissible friction forces of one contact, LG03 (2.15), (2.18), as a set that grows with its size
/// μλ_N: `dimension` rows of friction (0, 2 or 3), beside the one of the normal force.
///
///   support(size, gamma)    max of λ·γ: the potential Φ(−γ) = Φ(γ), LG03 (2.1)
///   gauge(force)            the size that just reaches the force
///   contains(force, size)   force ∈ domain
///   project(force, size)    nearest point, LG03 (4.12); derivative(q, force, size) its derivative, where q =
///                           project(force, size)
///
/// size = 0 is the set {0}. A negative or NaN or infinite size throws std::invalid_argument, a force or
/// velocity that is not finite std::domain_error.
template <class D>
concept FrictionDomain = requires(const D& domain, double size,
                                  const Eigen::Matrix<double, D::dimension, 1>& x,
                                  const Projection<D::dimension>& q) {
  { domain.support(size, x) } -> std::same_as<double>;
  { domain.gauge(x) } -> std::same_as<double>;
  { domain.contains(x, size) } -> std::same_as<bool>;
  { domain.project(x, size) } -> std::same_as<Projection<D::dimension>>;
  { domain.derivative(q, x, size) } -> std::same_as<ProjectionDerivative<D::dimension>>;
};

/// A contact without friction: one row, the normal force, and nothing else computed.
struct NoFriction {
  static constexpr int dimension = 0;
};

}  // namespace contensou
