#include "tippe_top.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace verify::augmented {
namespace {

using namespace contensou;

constexpr double time_step = 1e-4;

const AnyFriction& friction(double radius) {
  static const AnyFriction ball{FrictionBall(SmoothPlate(HertzLaw{}))};
  static const AnyFriction disk{FrictionDisk{}};
  return radius > 0 ? ball : disk;
}

}  // namespace

Matrix6 TippeTop::mass(double theta) const {
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  Matrix6 result = Matrix6::Zero();
  result.diagonal() << m, m, m, i1, i1 * s * s + i3 * c * c, i3;
  result(4, 5) = result(5, 4) = i3 * c;
  return result;
}

Vector6 TippeTop::force(double theta, const Vector6& u) const {
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  const double dtheta = u[3];
  const double dphi = u[4];
  const double dpsi = u[5];
  Vector6 h;
  h << 0, 0, -m * g, ((i1 - i3) * dphi * c - i3 * dpsi) * dphi * s,
      (2 * (i3 - i1) * dphi * c + i3 * dpsi) * dtheta * s, i3 * dphi * dtheta * s;
  return h;
}

Eigen::MatrixXd TippeTop::directions(int i, double theta, double radius) const {
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  Eigen::MatrixXd w(6, radius > 0 ? 4 : 3);
  w.col(0) << 0, 0, 1, -a[i] * s, 0, 0;
  w.col(1) << 1, 0, 0, 0, a[i] * s, r[i] * s;
  w.col(2) << 0, 1, 0, -(a[i] * c - r[i]), 0, 0;
  if (radius > 0) w.col(3) << 0, 0, 0, 0, radius, radius * c;
  return w;
}

double TippeTop::double_contact() const { return std::acos((r[0] - r[1]) / (a[0] - a[1])); }

std::vector<Case> cases() {
  const auto u = [](double dx, double dz, double dtheta, double dphi, double dpsi) {
    Vector6 x;
    x << dx, 0, dz, dtheta, dphi, dpsi;
    return x;
  };
  const double both = TippeTop{}.double_contact();
  // So slow a spin that friction stops it within the step, for the smallest radius, too.
  const Vector6 nudge = u(0, 0, 0, 2e-5, 0);
  std::vector<Case> all{
      {"body_slip", "the start of 5.4: body slides and spins", 0.1, u(0, 0, 0, 0, 180), {0}},
      {"body_stick", "body let go: it rolls", 0.1, nudge, {0}},
      {"body_drill", "almost upright, spinning on the spot", 1e-3, u(0, 0, 0, 0, 180), {0}},
      {"body_impact", "body falls on the floor, sliding and spinning", 0.1, u(0.1, -0.5, 0, 0, 180), {0}},
      {"tip_slip", "nearly inverted, on the tip", 2.8, u(0, 0, 0, 5, 100), {1}},
      {"tip_impact_stick", "the tip falls on the floor, hardly spinning", 2.8, u(0, -0.5, 0, 0.05, 0), {1}},
      {"both_slip", "body and tip on the floor, held there by precession", both, u(0, 0, 0, 20, -38), {0, 1}},
      {"both_let_go", "body and tip let go on the floor: the tip lifts", both, nudge, {0, 1}},
      {"both_impact", "body and tip strike the floor together", both, u(0, -0.05, 2.2, 0, 0), {0, 1}},
  };
  for (const double radius : {0.0, 5e-5, 1.5e-4, 1.5e-3, 5e-3}) {
    all.push_back({"body_stick", "body let go: it rolls", 0.1, nudge, {0}, radius});
  }
  return all;
}

Step step(const TippeTop& top, const Case& c) {
  const auto count = static_cast<Eigen::Index>(c.closed.size());
  Step s{top.mass(c.theta), c.u, top.force(c.theta, c.u) * time_step, {}, {}};
  const Eigen::Index rows = c.radius > 0 ? 4 : 3;
  s.w.resize(6, rows * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    s.w.middleCols(rows * i, rows) = top.directions(c.closed[static_cast<std::size_t>(i)], c.theta, c.radius);
  }
  const Eigen::LDLT<Matrix6> mass(s.mass);
  s.problem = {{{&friction(c.radius), std::vector<double>(c.closed.size(), top.mu)}},
               s.w.transpose() * mass.solve(s.w),
               s.w.transpose() * (c.u + mass.solve(s.smooth))};
  return s;
}

}  // namespace verify::augmented
