#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/contact/reduced_contact.hpp"

namespace contensou::detail {

/// The ellipsoid a‖x_T‖² + c x_τ² = 1 (Λ_F in units of μΛ_N) that touches the friction ball where the speeds
/// are (v, s): a = v/(ξφ), c = s/(ηφ), φ = vξ + sη. A disk is its own: a = 1.
struct Ellipsoid {
  double a;
  double c;
};

/// The equation in σ: for x(σ) = −(a + σD)⁻¹ b, μ(n0 + g·x) = size of the ellipsoid through x.
template <int dimension>
class Secular {
 public:
  using Vector = Eigen::Matrix<double, dimension, 1>;

  /// `c` must live as long as this.
  explicit Secular(const ReducedContact<dimension>& c) : contact_(c), polynomials_(c) {}

  const CramerPolynomials<dimension>& polynomials() const { return polynomials_; }

  struct Point {
    Cramer<dimension> at;
    double inverse_size;  ///< of the ellipsoid through p
    double ratio;         ///< μΛ_N det/size, 1 at the root; nearly linear in σ
  };
  Point point(const Ellipsoid& e, double sigma) const {
    Point q{polynomials_.value(sigma * e.a, sigma * e.c), 0, 0};
    q.inverse_size = 1 / std::sqrt(square(e, q.at.p, q.at.p));
    q.ratio = contact_.mu * (contact_.n0 * q.at.det - contact_.g.dot(q.at.p)) * q.inverse_size;
    return q;
  }
  /// Derivative of the point's ratio, and of p in `dp`, along (dα, dβ) with the ellipsoid kept.
  double slope(const Ellipsoid& e, double sigma, const Point& q, double d_alpha, double d_beta,
               Vector& dp) const {
    const auto d = polynomials_.derivative(sigma * e.a, sigma * e.c, d_alpha, d_beta);
    dp = d.p;
    const double d_size = square(e, q.at.p, dp) * q.inverse_size;
    return (contact_.mu * (contact_.n0 * d.det - contact_.g.dot(dp)) - q.ratio * d_size) * q.inverse_size;
  }

  struct Root {
    double sigma;
    Point point;
    double slope;  ///< ∂ratio/∂σ
    Vector dp;     ///< ∂p/∂σ
    bool found;
    bool clipped;  ///< ratio >= 1 already at σ = 0, as near as rounding lets
    int iterations;
  };
  /// The root from `guess` > 0 on, bracketed.
  Root solve(const Ellipsoid& e, double guess) const;

 private:
  static double square(const Ellipsoid& e, const Vector& x, const Vector& y) {
    if constexpr (dimension == 2) {
      return e.a * x.dot(y);
    } else {
      return e.a * (x[0] * y[0] + x[1] * y[1]) + e.c * (x[2] * y[2]);
    }
  }

  const ReducedContact<dimension>& contact_;
  CramerPolynomials<dimension> polynomials_;
};

template <int dimension>
typename Secular<dimension>::Root Secular<dimension>::solve(const Ellipsoid& e, double guess) const {
  constexpr int most_iterations = 100;
  constexpr double small_step = 0x1p-28;
  // A velocity σDx that is lost in the rounding of a x.
  const double floor = 0x1p-54 * contact_.a.cwiseAbs().maxCoeff() / std::max(e.a, e.c);
  double low = 0;
  double high = std::numeric_limits<double>::infinity();
  double sigma = std::max(guess, floor);
  Root root{};
  double step_before = high;
  for (int i = 1; i <= most_iterations; ++i) {
    root.sigma = sigma;
    root.iterations = i;
    root.point = point(e, sigma);
    root.slope = slope(e, sigma, root.point, e.a, e.c, root.dp);
    const double missing = 1 - root.point.ratio;
    if (!std::isfinite(missing)) return root;
    if (sigma <= floor && missing <= 0) {
      root.found = root.clipped = true;
      return root;
    }
    (missing > 0 ? low : high) = sigma;
    double next = sigma + missing / root.slope;
    const double step = std::abs(next - sigma);
    if (root.slope > 0 && (step <= small_step * sigma || step <= floor)) {
      root.point.at.p += (next - sigma) * root.dp;
      root.sigma = next;
      root.found = true;
      return root;
    }
    const bool newton = root.slope > 0 && next > low && next < high && 2 * step <= step_before;
    if (!newton) {
      if (std::isinf(high)) {
        next = next > sigma ? std::min(next, 1024 * sigma) : 16 * sigma;
      } else if (low == 0) {
        next = std::max(floor, next < low ? floor : high / 16);
        if (floor == 0 && next == 0) next = high / 1024;
      } else {
        next = high > 4 * low ? std::sqrt(low) * std::sqrt(high) : low + (high - low) / 2;
      }
      if (std::isfinite(high) && high - low <= 0x1p-52 * high) {
        root.found = true;
        return root;
      }
    }
    step_before = newton ? step : high - low;
    sigma = next;
  }
  return root;
}

}  // namespace contensou::detail
