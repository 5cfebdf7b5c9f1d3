#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace contensou::detail {

/// One contact with Λ_N eliminated by γ_N = 0: γ_F = a x + b and Λ_N = n0 + g·x for the friction x = Λ_F. In
/// units of V = max |b| and V/W_NN.
template <int dimension>
struct ReducedContact {
  using Vector = Eigen::Matrix<double, dimension, 1>;
  using Matrix = Eigen::Matrix<double, dimension, dimension>;

  Matrix a;
  Vector b;
  Vector g;
  double n0;
  double mu;

  double normal(const Vector& x) const { return n0 + g.dot(x); }
};

/// W and b without Λ_N, `speed` = V. A singular or nearly singular a is rounding in some direction, and as
/// likely as not negative there: a compliance that moves the contact by less than the tolerance makes it
/// positive definite again.
template <int dimension>
ReducedContact<dimension> reduce_contact(double mu,
                                         const Eigen::Matrix<double, dimension + 1, dimension + 1>& w,
                                         const Eigen::Matrix<double, dimension + 1, 1>& b, double speed) {
  using Vector = Eigen::Matrix<double, dimension, 1>;
  constexpr double singular = 1e-9;
  constexpr double compliance = 0x1p-45;
  const double scale = 1 / w(0, 0);
  const Vector column = scale * w.template bottomLeftCorner<dimension, 1>();
  const Vector row = scale * w.template topRightCorner<1, dimension>().transpose();
  const Vector diagonal = scale * w.diagonal().template tail<dimension>();
  ReducedContact<dimension> c;
  c.a = scale * w.template bottomRightCorner<dimension, dimension>() - column * row.transpose();
  c.n0 = -b[0] / speed;
  c.b = b.template tail<dimension>() / speed + column * c.n0;
  c.g = -row;
  c.mu = mu;
  if (!(c.a.determinant() > singular * diagonal.prod())) c.a.diagonal() += compliance * diagonal;
  return c;
}

/// (a + D)⁻¹ b for D = diag(α, α, β) or diag(α, α): adjugate times b, and determinant, as polynomials in α
/// and β. Being polynomials they need no pivots and hold for singular a.
template <int dimension>
struct Cramer {
  Eigen::Matrix<double, dimension, 1> p;  ///< adj(a + D) b
  double det;
};

template <int dimension>
class CramerPolynomials;

template <>
class CramerPolynomials<2> {
 public:
  explicit CramerPolynomials(const ReducedContact<2>& c)
      : b_(c.b),
        p0_(c.a(1, 1) * c.b[0] - c.a(0, 1) * c.b[1], c.a(0, 0) * c.b[1] - c.a(1, 0) * c.b[0]),
        det0_(c.a(0, 0) * c.a(1, 1) - c.a(0, 1) * c.a(1, 0)),
        trace_(c.a(0, 0) + c.a(1, 1)) {}

  Cramer<2> value(double alpha, double /*beta*/) const {
    return {p0_ + alpha * b_, det0_ + alpha * (trace_ + alpha)};
  }
  /// Along (dα, dβ).
  Cramer<2> derivative(double alpha, double /*beta*/, double d_alpha, double /*d_beta*/) const {
    return {d_alpha * b_, d_alpha * (trace_ + 2 * alpha)};
  }

 private:
  Eigen::Vector2d b_;
  Eigen::Vector2d p0_;
  double det0_;
  double trace_;
};

template <>
class CramerPolynomials<3> {
 public:
  explicit CramerPolynomials(const ReducedContact<3>& c) : b_(c.b) {
    const Eigen::Vector3d r0 = c.a.row(0);
    const Eigen::Vector3d r1 = c.a.row(1);
    const Eigen::Vector3d r2 = c.a.row(2);
    const Eigen::Vector3d m0 = r1.cross(r2);
    const Eigen::Vector3d m1 = r2.cross(r0);
    const Eigen::Vector3d m2 = r0.cross(r1);
    p0_ = m0 * b_[0] + m1 * b_[1] + m2 * b_[2];
    det0_ = r0.dot(m0);
    det_alpha_ = m0[0] + m1[1];
    det_beta_ = m2[2];
    trace_t_ = r0[0] + r1[1];
    tau_ = r2[2];
    // The rows of a + D are r_i + d_i e_i: what D adds to their cross products.
    p_alpha_ = Eigen::Vector3d(r2[2] * b_[0] - r0[2] * b_[2], r2[2] * b_[1] - r1[2] * b_[2],
                               trace_t_ * b_[2] - r2[0] * b_[0] - r2[1] * b_[1]);
    p_beta_ = Eigen::Vector3d(r1[1] * b_[0] - r0[1] * b_[1], r0[0] * b_[1] - r1[0] * b_[0], 0);
  }

  Cramer<3> value(double alpha, double beta) const {
    const double t = alpha * beta;
    const double tau = alpha * alpha;
    return {p0_ + alpha * p_alpha_ + beta * p_beta_ + Eigen::Vector3d(t * b_[0], t * b_[1], tau * b_[2]),
            det0_ + alpha * det_alpha_ + beta * det_beta_ + t * trace_t_ + tau * (tau_ + beta)};
  }
  /// Along (dα, dβ).
  Cramer<3> derivative(double alpha, double beta, double d_alpha, double d_beta) const {
    const double t = d_alpha * beta + alpha * d_beta;
    const double tau = 2 * alpha * d_alpha;
    return {d_alpha * p_alpha_ + d_beta * p_beta_ + Eigen::Vector3d(t * b_[0], t * b_[1], tau * b_[2]),
            d_alpha * det_alpha_ + d_beta * det_beta_ + t * trace_t_ + tau * (tau_ + beta) +
                alpha * alpha * d_beta};
  }

 private:
  Eigen::Vector3d b_;
  Eigen::Vector3d p0_;
  Eigen::Vector3d p_alpha_;
  Eigen::Vector3d p_beta_;
  double det0_;
  double det_alpha_;
  double det_beta_;
  double trace_t_;
  double tau_;
};

}  // namespace contensou::detail
