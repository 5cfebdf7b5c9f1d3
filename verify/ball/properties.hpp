#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

#include "contensou/ball/friction_ball.hpp"
#include "oracle.hpp"
#include "sample.hpp"

namespace verify::ball {

/// What is asked of every projection, and measured in ulp of the scale: 2^-52 max(‖λ_F‖, μλ_N), at least the
/// smallest double.
enum Property : std::size_t {
  finite,         ///< a result that is no number, or a normal that is no unit vector: 1, else 0
  parallel,       ///< force − point beside the normal, or against it
  border,         ///< point off the border, by the oracle
  distance,       ///< distance given, against force − point; infinite only beyond the range of doubles
  residual,       ///< residual given, against what force − point has beside the normal
  inside,         ///< inside by projection but not by gauge, or the other way: by how much
  idempotent,     ///< how far the projection of the projection moves
  non_expansive,  ///< by how much two points come out farther apart than they were
  symmetric,      ///< any other bit after a mirroring (zeros may differ in sign): 1, else 0
  homogeneous,    ///< derivative D not symmetric, D p + size ∂q/∂size ≠ q; relative to max(1, ‖D‖)
  contracting,    ///< eigenvalues of D beside [0, 1]
  property_count,
};

inline constexpr std::array<const char*, property_count> property_names{"finite",
                                                                        "parallel",
                                                                        "border",
                                                                        "distance",
                                                                        "residual",
                                                                        "inside",
                                                                        "idempotent",
                                                                        "non_expansive",
                                                                        "symmetric",
                                                                        "derivative_homogeneous",
                                                                        "derivative_contracting"};

struct Statistics {
  std::array<std::uint64_t, property_count> points{};
  std::array<double, property_count> worst{};
  std::map<int, std::uint64_t> iterations;  ///< of the projections that were not in closed form

  void add(Property property, Real error) {
    ++points[property];
    const double e = std::isnan(error) ? std::numeric_limits<double>::infinity() : static_cast<double>(error);
    worst[property] = std::max(worst[property], e);
  }
};

using Vector = Eigen::Matrix<Real, 3, 1>;

inline Real length(const Vector& x) { return std::hypot(x[0], x[1], x[2]); }

/// max(0, x); a NaN stays one.
inline Real positive_part(Real x) { return x <= 0 ? 0 : x; }

inline Real ulp(const FrictionForce& force, double size) {
  return std::max(0x1p-52L * std::max(length(force.cast<Real>()), Real(size)), Real(0x1p-1074));
}

inline Pair meridian(const Vector& x) { return {std::hypot(x[0], x[1]), std::abs(x[2])}; }

/// One of the ball's symmetries: three signs and the exchange of the tangential components.
inline FrictionForce mirrored(FrictionForce x, std::uint64_t which) {
  for (int i = 0; i < 3; ++i) {
    if ((which >> i & 1) != 0) x[i] = -x[i];
  }
  if ((which >> 3 & 1) != 0) std::swap(x[0], x[1]);
  return x;
}

inline void judge_border(const Question& question, const contensou::Projection<3>& q, const Oracle& oracle,
                         Statistics& s) {
  const Vector p = question.force.cast<Real>();
  const Vector x = q.point.cast<Real>();
  const Vector n = q.normal.cast<Real>();
  const Real unit = length(n);
  const bool good = q.point.allFinite() && std::abs(unit - 1) <= 4 * 0x1p-52L && q.distance >= 0;
  s.add(finite, good ? 0 : 1);
  const Real scale = ulp(question.force, question.size);
  const Vector rest = p - x;
  const Real along = rest.dot(n) / unit;
  const Real beside = length(rest - along / unit * n);
  s.add(parallel, (beside + positive_part(-along)) / scale);
  // A length beyond the range of doubles is rightly infinite.
  const auto add_length = [&](Property property, double given, Real length) {
    constexpr Real largest = std::numeric_limits<double>::max();
    const bool beyond = std::isinf(given) && length > largest * (1 - 0x1p-50L);
    s.add(property, beyond ? 0 : std::abs(given - length) / scale);
  };
  add_length(distance, q.distance, along);
  add_length(residual, q.residual, beside);
  if (question.size == 0) {
    s.add(border, length(x) / scale);
  } else {
    const auto [t, tau] = meridian(x / question.size);
    const auto [nt, ntau] = meridian(n / unit);
    const Real off = oracle({t, tau}, {nt, ntau});
    if (!std::isnan(off)) s.add(border, off * question.size / scale);
  }
}

template <class Ball>
void judge_derivative(const Ball& ball, const Question& question, const contensou::Projection<3>& q,
                      Statistics& s) {
  const contensou::ProjectionDerivative<3> d = ball.derivative(q, question.force, question.size);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(d.force);
  const Eigen::Vector3d values = eigen.eigenvalues();
  const Real norm = std::max(1.0, values.cwiseAbs().maxCoeff());
  const Vector sum = d.force.cast<Real>() * question.force.cast<Real>() + question.size * d.size.cast<Real>();
  const Real apart = length(sum - q.point.cast<Real>()) / ulp(question.force, question.size);
  // A NaN anywhere in D is one here.
  const Real skew = (d.force - d.force.transpose()).norm() / 0x1p-52L;
  s.add(homogeneous, skew / norm);
  s.add(homogeneous, apart / norm);
  s.add(contracting, positive_part(-values[0]) / 0x1p-52L);
  s.add(contracting, positive_part(values[2] - 1) / 0x1p-52L);
}

/// All properties at one question. `which`: of the mirrorings; 0 to 15.
template <class Ball>
void judge(const Ball& ball, const Question& question, std::uint64_t which, const Oracle& oracle,
           Statistics& s) {
  const auto& [force, other, size] = question;
  const contensou::Projection<3> q = ball.project(force, size);
  const Real scale = ulp(force, size);
  if (q.iterations > 0) ++s.iterations[q.iterations];
  if (!q.inside) {
    judge_border(question, q, oracle, s);
    const contensou::Projection<3> again = ball.project(q.point, size);
    s.add(idempotent, length((again.point - q.point).template cast<Real>()) / ulp(q.point, size));
    if (which == 0) judge_derivative(ball, question, q, s);
  }
  const Real excess = Real(ball.gauge(force)) - size;
  s.add(inside, positive_part(q.inside ? excess : -excess) / scale);

  const contensou::Projection<3> beside = ball.project(other, size);
  const Real before = length(force.cast<Real>() - other.cast<Real>());
  const Real after = length(q.point.template cast<Real>() - beside.point.template cast<Real>());
  s.add(non_expansive, positive_part(after - before) / std::max(scale, ulp(other, size)));

  const contensou::Projection<3> mirror = ball.project(mirrored(force, which), size);
  const bool same = mirrored(q.point, which) == mirror.point && mirrored(q.normal, which) == mirror.normal &&
                    q.distance == mirror.distance && q.iterations == mirror.iterations;
  s.add(symmetric, same ? 0 : 1);
}

}  // namespace verify::ball
