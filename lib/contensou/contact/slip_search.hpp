#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/friction_disk.hpp"
#include "contensou/ball/smooth_plate.hpp"
#include "contensou/contact/reduced_contact.hpp"

namespace contensou::detail {

/// The ellipsoid a‖x_T‖² + c x_τ² = φ (Λ_F in units of μΛ_N) that touches the friction ball where the speeds
/// are (v, s): a = v/ξ, c = s/η, φ = vξ + sη. A disk is its own: a = φ = 1.
struct Ellipsoid {
  double a;
  double c;
  double phi;
};

/// What the search for slip ends with.
template <int dimension>
struct SlipEnd {
  Eigen::Matrix<double, dimension, 1> friction;   ///< Λ_F
  double normal;                                  ///< Λ_N
  Eigen::Matrix<double, dimension, 1> direction;  ///< unit vector: where γ_F points
  bool found;
  bool sticks;  ///< σ = 0: the friction stops the contact and is not on the border
  int iterations;
};

/// The equation in σ: for x(σ) = −(a + σD)⁻¹ b, μ(n0 + g·x) = size of the ellipsoid through x.
template <int dimension>
class Secular {
 public:
  using Vector = Eigen::Matrix<double, dimension, 1>;

  explicit Secular(const ReducedContact<dimension>& c) : contact_(c), polynomials_(c) {}

  struct Point {
    Cramer<dimension> at;
    double size;   ///< of the ellipsoid through p
    double ratio;  ///< μΛ_N det/size, 1 at the root; nearly linear in σ
  };
  Point point(const Ellipsoid& e, double sigma) const {
    Point q{polynomials_.value(sigma * e.a, sigma * e.c), 0, 0};
    q.size = std::sqrt(square(e, q.at.p, q.at.p) / e.phi);
    q.ratio = contact_.mu * (contact_.n0 * q.at.det - contact_.g.dot(q.at.p)) / q.size;
    return q;
  }
  /// Derivative of the point's ratio, and of p in `dp`, along (dα, dβ) with the ellipsoid kept.
  double slope(const Ellipsoid& e, double sigma, const Point& q, double d_alpha, double d_beta,
               Vector& dp) const {
    const auto d = polynomials_.derivative(sigma * e.a, sigma * e.c, d_alpha, d_beta);
    dp = d.p;
    const double d_size = square(e, q.at.p, dp) / (e.phi * q.size);
    return (contact_.mu * (contact_.n0 * d.det - contact_.g.dot(dp)) - q.ratio * d_size) / q.size;
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

/// Coulomb's disk: one equation.
inline SlipEnd<2> search_slip(const FrictionDisk&, const ReducedContact<2>& c, const Eigen::Vector2d& guess) {
  const Secular<2> secular(c);
  const double a = (c.a(0, 0) + c.a(1, 1)) / 2;
  const double sigma = guess.norm() / (c.mu * c.n0);
  const auto root = secular.solve({1, 0, 1}, std::max(sigma - a, sigma / 16));
  SlipEnd<2> end{};
  end.iterations = root.iterations;
  if (!root.found) return end;
  end.direction = root.point.at.p.normalized();
  end.sticks = root.clipped;
  if (root.clipped) {
    end.friction = -root.point.at.p / root.point.at.det;
    end.normal = c.normal(end.friction);
  } else {
    end.normal = c.n0 / (1 + c.mu * c.g.dot(end.direction));
    end.friction = -c.mu * end.normal * end.direction;
  }
  end.found = end.normal > 0;
  return end;
}

/// A border point of the plate and its normal (v, s), the larger component 1, with derivatives by the
/// smaller, x: u for `inner`, 1/u else.
struct BorderPoint {
  Friction force;
  Friction d_force;
  Ellipsoid ellipsoid;
  double d_a;
  double d_c;
  double d_phi;
};

template <class Law>
BorderPoint border_point(const Law& law, bool inner, double x) {
  BorderPoint q{};
  q.force = inner ? law.at(x, 1) : law.at(1, x);
  const auto [xi, eta] = q.force;
  const double k = inner ? law.curvature(x, 1).vv : law.curvature(1, x).ss;
  // x/force and its derivative, whose difference is rounding below this.
  constexpr double small = 1e-6;
  const double along = inner ? xi : eta;
  const double other = inner ? eta : xi;
  const double ratio = x > 0 && along > 0 ? x / along : 1 / k;
  const double d_ratio = x > small ? (1 - k * ratio) / along : 0;
  const double inverse = 1 / other;
  const double d_inverse = x * k * inverse * inverse;
  if (inner) {
    q.d_force = {k, -x * k};
    q.ellipsoid = {ratio, inverse, x * xi + eta};
    q.d_a = d_ratio;
    q.d_c = d_inverse;
    q.d_phi = xi;
  } else {
    q.d_force = {-x * k, k};
    q.ellipsoid = {inverse, ratio, xi + x * eta};
    q.d_a = d_inverse;
    q.d_c = d_ratio;
    q.d_phi = eta;
  }
  return q;
}

/// A slip ratio: u = x for `inner`, u = 1/x else.
struct SlipPlace {
  bool inner;
  double x;
  bool operator<(const SlipPlace& other) const {
    if (inner != other.inner) return inner;
    return inner ? x < other.x : x > other.x;
  }
};

inline SlipPlace slip_place(double v, double s) {
  return v <= s ? SlipPlace{true, s > 0 ? v / s : 0} : SlipPlace{false, s / v};
}

/// Halfway between two places.
inline SlipPlace between(SlipPlace low, SlipPlace high) {
  if (low.inner == high.inner) return {low.inner, low.x + (high.x - low.x) / 2};
  return low.x < 1 ? SlipPlace{true, low.x + (1 - low.x) / 2} : SlipPlace{false, (1 + high.x) / 2};
}

/// The end where slip has this direction: `place` and the direction of p.
template <class Law>
void finish_slip(const Law& law, const ReducedContact<3>& c, const Secular<3>::Root& root, SlipPlace place,
                 const Eigen::Vector3d& p, SlipEnd<3>& end) {
  const double t = p.head<2>().norm();
  const Eigen::Vector2d e = t > 0 ? Eigen::Vector2d(p.head<2>() / t) : Eigen::Vector2d(1, 0);
  const double sign = std::copysign(1.0, p[2]);
  const double v = place.inner ? place.x : 1;
  const double s = place.inner ? 1 : place.x;
  end.direction = Eigen::Vector3d(v * e[0], v * e[1], sign * s).normalized();
  end.sticks = root.clipped;
  if (root.clipped) {
    end.friction = -p / root.point.at.det;
    end.normal = c.normal(end.friction);
  } else {
    const auto [xi, eta] = law.at(v, s);
    const Eigen::Vector3d unit(xi * e[0], xi * e[1], sign * eta);
    end.normal = c.n0 / (1 + c.mu * c.g.dot(unit));
    end.friction = -c.mu * end.normal * unit;
  }
  end.found = end.normal > 0;
}

/// Coulomb–Contensou's ball: where on the border, and for each such place the equation in σ. Along the border
/// from the pole to the equator, x lies first outward, then inward of it: ‖x_T‖η − |x_τ|ξ changes its sign.
template <class Law>
SlipEnd<3> search_slip(const FrictionBall<SmoothPlate<Law>>& ball, const ReducedContact<3>& c,
                       const Eigen::Vector3d& guess) {
  constexpr int most_iterations = 100;
  constexpr double small_step = 0x1p-28;
  const Law& law = ball.plate().law();
  const Secular<3> secular(c);
  SlipEnd<3> end{};

  SlipPlace low{true, 0};
  SlipPlace high{false, 0};
  const double v = guess.head<2>().norm();
  const double s = std::abs(guess[2]);
  SlipPlace place = slip_place(v, s);
  double sigma = 0;
  double step_before = 2;
  for (int i = 1; i <= most_iterations; ++i) {
    const BorderPoint border = border_point(law, place.inner, place.x);
    const Ellipsoid& e = border.ellipsoid;
    if (i == 1) sigma = std::sqrt((v * v / e.a + s * s / e.c) / e.phi) / (c.mu * c.n0);
    const auto root = secular.solve(e, sigma);
    end.iterations += root.iterations;
    if (!root.found) return end;

    const Eigen::Vector3d p = root.point.at.p;
    const double size = root.point.size;
    const double t = p.head<2>().norm();
    const double tau = std::abs(p[2]);
    const double value = (t * border.force.eta - tau * border.force.xi) / size;
    // Total derivative along the border, σ following.
    Eigen::Vector3d dp;
    double d_ratio =
        secular.slope(e, root.sigma, root.point, root.sigma * border.d_a, root.sigma * border.d_c, dp);
    d_ratio -= root.point.ratio * ((border.d_a * t * t + border.d_c * tau * tau) / (2 * e.phi * size * size) -
                                   border.d_phi / (2 * e.phi));
    const double d_sigma = root.clipped ? 0 : -d_ratio / root.slope;
    dp += d_sigma * root.dp;
    const double dt = t > 0 ? p.head<2>().dot(dp.head<2>()) / t : 0;
    const double d_tau = std::copysign(1.0, p[2]) * dp[2];
    const double d_value =
        (dt * border.force.eta + t * border.d_force.eta - d_tau * border.force.xi - tau * border.d_force.xi) /
        size;

    (value > 0 ? low : high) = place;
    const double next = place.x - value / d_value;
    const double step = std::abs(next - place.x);
    const bool falls = place.inner ? d_value < 0 : d_value > 0;
    SlipPlace goal =
        next <= 1 ? SlipPlace{place.inner, std::max(next, 0.0)} : SlipPlace{!place.inner, 1 / next};
    const bool newton = falls && 2 * step <= step_before && !(goal < low) && !(high < goal);
    const bool done = value == 0 || (newton && step <= small_step * place.x);
    if (done) {
      const double dx = value == 0 ? 0 : next - place.x;
      finish_slip(law, c, root, {place.inner, place.x + dx}, p + dx * dp, end);
      return end;
    }
    step_before = newton ? step : 2;
    sigma = root.clipped
                ? root.sigma
                : root.sigma + (newton ? d_sigma * (goal.inner == place.inner ? goal.x - place.x : 0) : 0);
    if (!(sigma > 0)) sigma = root.sigma;
    place = newton ? goal : between(low, high);
  }
  return end;
}

}  // namespace contensou::detail
