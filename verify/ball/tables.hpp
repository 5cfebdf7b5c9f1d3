#pragma once

#include <vector>

#include "accuracy/reference.hpp"
#include "oracle.hpp"
#include "properties.hpp"

/// The projection against the stored tables of 34 digits: border points that are known exactly.
namespace verify::ball {

/// A border point of the plate of size 1 with its unit outward normal.
struct BorderPoint {
  Pair point;
  Pair normal;
  Real support;
};

std::vector<BorderPoint> border_points(const std::vector<accuracy::ReferenceRow>& rows);

struct TableErrors {
  std::uint64_t known = 0;
  double worst_known = 0;  ///< |projection of (point + distance normal) − point| in ulp of the scale
  std::uint64_t fan = 0;
  double worst_fan = 0;  ///< by how much a normal of the table says more distance than the projection does
};

/// Forces above each border point, at distances from 1e-17 to 1e17; and sampled forces against the whole fan.
template <class Ball>
TableErrors judge_by_table(const Ball& ball, const std::vector<BorderPoint>& border) {
  constexpr Real e1 = 0.6L;
  constexpr Real e2 = 0.8L;
  TableErrors errors;
  for (const auto& [x, n, support] : border) {
    for (Real d = 1e-17L; d < 2e17L; d *= 10) {
      const Real t = x.t + d * n.t;
      const FrictionForce p(static_cast<double>(e1 * t), static_cast<double>(-e2 * t),
                            static_cast<double>(x.tau + d * n.tau));
      const Vector found = ball.project(p, 1).point.template cast<Real>();
      const Real error = length(found - Vector(e1 * x.t, -e2 * x.t, x.tau)) / ulp(p, 1);
      errors.worst_known = std::max(errors.worst_known, static_cast<double>(error));
      ++errors.known;
    }
  }
  Sample sample(20260);
  for (int i = 0; i < 3000; ++i) {
    const Question question = sample.next(ball);
    const contensou::Projection<3> q = ball.project(question.force, question.size);
    if (!std::isfinite(q.distance)) continue;
    const Pair p = meridian(question.force.cast<Real>());
    Real farthest = 0;
    for (const BorderPoint& b : border) {
      farthest = std::max(farthest, p.t * b.normal.t + p.tau * b.normal.tau - question.size * b.support);
    }
    const Real error = (farthest - q.distance) / ulp(question.force, question.size);
    errors.worst_fan = std::max(errors.worst_fan, static_cast<double>(error));
    ++errors.fan;
  }
  return errors;
}

}  // namespace verify::ball
