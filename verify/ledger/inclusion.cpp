#include "inclusion.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle.hpp"

namespace verify::ledger {
namespace hertz_ball {
namespace {

/// The chord integrals of oracle.hpp in double; (ξ, η) for speeds v, s >= 0.
Eigen::Vector2d chords(double v, double s) {
  const double quarter = std::numbers::pi / 2;
  if (v <= s) {
    const double u = v / s;
    const auto h2 = [&](double c) { return (1 - u) * (1 + u) + u * u * c * c; };
    return {1.5 * u *
                integrate_double([&](double t) { return std::pow(std::sin(t), 2) * h2(std::sin(t)); }, 0,
                                 quarter),
            0.375 * integrate_double([&](double t) { return std::pow(h2(std::sin(t)), 2); }, 0, quarter)};
  }
  const double w = s / v;
  const auto c = [&](double h) { return std::sqrt((1 - w) * (1 + w) + w * w * h * h); };
  return {
      1.5 * integrate_double([&](double t) { return c(std::sin(t)) * std::pow(std::sin(t), 3); }, 0, quarter),
      0.375 * w *
          integrate_double([&](double t) { return std::pow(std::sin(t), 5) / c(std::sin(t)); }, 0, quarter)};
}

}  // namespace

double support(const Eigen::Vector3d& gamma) {
  const Eigen::Vector2d speeds(gamma.head<2>().norm(), std::abs(gamma[2]));
  return speeds.isZero(0) ? 0 : speeds.dot(chords(speeds[0], speeds[1]));
}

Eigen::Vector2d border(double v, double s) { return chords(v, s); }

Eigen::Vector3d prox(const Eigen::Vector3d& x, double size) {
  const Eigen::Vector2d p(x.head<2>().norm(), std::abs(x[2]));
  // (p − size·border)·tangent changes sign where the normal points at p.
  double low = 0;
  double high = std::numbers::pi / 2;
  for (int i = 0; i < 52; ++i) {
    const double psi = low + (high - low) / 2;
    const Eigen::Vector2d rest = p - size * chords(std::sin(psi), std::cos(psi));
    (rest[0] * std::cos(psi) - rest[1] * std::sin(psi) > 0 ? low : high) = psi;
  }
  const Eigen::Vector2d normal(std::sin(low), std::cos(low));
  const Eigen::Vector2d nearest = size * chords(normal[0], normal[1]);
  if ((p - nearest).dot(normal) <= 0) return x;
  Eigen::Vector3d result(0, 0, std::copysign(nearest[1], x[2]));
  if (p[0] > 0) result.head<2>() = x.head<2>() * (nearest[0] / p[0]);
  return result;
}

std::vector<Eigen::Vector3d> cover(int steps) {
  std::vector<Eigen::Vector3d> points;
  const double angle = std::numbers::pi / 2 / steps;
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d b = chords(std::sin(i * angle), std::cos(i * angle));
    for (int k = 0; k < 4 * steps; ++k) {
      const double x = b[0] * std::cos(k * angle);
      const double y = b[0] * std::sin(k * angle);
      points.emplace_back(x, y, b[1]);
      points.emplace_back(x, y, -b[1]);
    }
  }
  return points;
}

}  // namespace hertz_ball

Inclusion::Vector6 Inclusion::motion(double normal, const Eigen::Vector3d& friction) const {
  return mass.ldlt().solve(smooth + w_n * normal + w_f * friction);
}

double Inclusion::largest_eigenvalue() const {
  Eigen::Matrix<double, 6, 4> w;
  w << w_n, w_f;
  const Eigen::Matrix4d delassus = w.transpose() * mass.ldlt().solve(w);
  return delassus.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff();
}

Inclusion::Point Inclusion::iterate(double r, int times) const {
  Point p{Vector6::Zero(), 0, Eigen::Vector3d::Zero()};
  for (int k = 0; k < times; ++k) {
    p.change = motion(p.normal, p.friction);
    const double normal = std::max(0.0, p.normal - r * gamma_n(p.change));
    const Eigen::Vector3d friction = hertz_ball::prox(p.friction - r * gamma_f(p.change), mu * normal);
    const double moved = std::abs(normal - p.normal) + (friction - p.friction).norm();
    p.normal = normal;
    p.friction = friction;
    if (moved <= 1e-15 * normal) break;
  }
  p.change = motion(p.normal, p.friction);
  return p;
}

double Inclusion::lagrangian(const Point& p, double r, const Size& size) const {
  const double n = gamma_n(p.change);
  const Eigen::Vector3d f = gamma_f(p.change);
  const Vector6 rest = p.change - mass.ldlt().solve(smooth);
  const double below = std::min(0.0, p.normal - r * n);
  const Eigen::Vector3d x = p.friction - r * f;
  return rest.dot(mass * rest) / 2 - n * p.normal - f.dot(p.friction) + r / 2 * n * n -
         below * below / (2 * r) + r / 2 * f.squaredNorm() -
         (x - hertz_ball::prox(x, size(p))).squaredNorm() / (2 * r);
}

double Inclusion::slope(const Point& p, const Point& d, double r, const Size& size, double step) const {
  const auto at = [&](double h) {
    return lagrangian({p.change + h * d.change, p.normal + h * d.normal, p.friction + h * d.friction}, r,
                      size);
  };
  return (at(step) - at(-step)) / (2 * step);
}

Inclusion sliding() {
  Inclusion i;
  // Any symmetric positive definite matrix and any directions will do.
  Eigen::Matrix<double, 6, 6> a;
  for (int k = 0; k < 36; ++k) a(k / 6, k % 6) = std::sin(1.7 * k * k + 0.3 * k + 0.1);
  i.mass = a * a.transpose() + 2 * Eigen::Matrix<double, 6, 6>::Identity();
  for (int k = 0; k < 6; ++k) {
    i.smooth[k] = 0.2 * std::cos(2.3 * k);
    i.w_n[k] = std::cos(0.9 * k * k);
    for (int j = 0; j < 3; ++j) i.w_f(k, j) = std::sin(1.1 * k * (j + 1) + j);
  }
  i.before = -1.5 * i.w_n + i.w_f * Eigen::Vector3d(0.8, -0.5, 0.6);
  i.mu = 0.25;
  return i;
}

Inclusion sticking() {
  Inclusion i = sliding();
  i.mu = 4;
  return i;
}

}  // namespace verify::ledger
