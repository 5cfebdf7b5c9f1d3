#include "contensou/system/tippe_top_euler.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "differences.hpp"
#include "tippe_top_states.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Matrix3d elementary(double angle, int i, int j) {
  Matrix3d t = Matrix3d::Identity();
  t(i, i) = t(j, j) = std::cos(angle);
  t(i, j) = std::sin(angle);
  t(j, i) = -std::sin(angle);
  return t;
}

/// Body to floor, A^{14}, from LG03 (5.1).
Matrix3d attitude(const Eigen::VectorXd& q) {
  return (elementary(q[5], 0, 1) * elementary(q[3], 1, 2) * elementary(q[4], 0, 1)).transpose();
}

/// ω in the floor's axes, linear in u, from the attitude's derivatives alone.
Vector3d spin(const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
  const Matrix3d turning = rate([&](double t) -> Matrix3d { return attitude(q + t * u); });
  const Matrix3d w = turning * attitude(q).transpose();
  return {w(2, 1), w(0, 2), w(1, 0)};
}

/// T − V of a rigid body, of its definition.
double lagrangian(const TippeTopData& d, const Eigen::VectorXd& q, const Eigen::VectorXd& u) {
  const Vector3d omega = attitude(q).transpose() * spin(q, u);
  return (d.m * u.head<3>().squaredNorm() + omega.dot(Vector3d(d.i1, d.i1, d.i3).cwiseProduct(omega))) / 2 -
         d.m * d.g * q[2];
}

/// The k-th left-hand side of Lagrange's equations, (5.7), at q̈: ∂L/∂q̇ by a central difference, which is
/// exact of a quadratic function; the others by five points.
double euler_lagrange(const TippeTopData& d, const State& s, const Eigen::VectorXd& acceleration, int k) {
  const Eigen::VectorXd unit = Eigen::VectorXd::Unit(6, k);
  const auto momentum = [&](double t) {
    const Eigen::VectorXd q = s.q + t * s.u + t * t / 2 * acceleration;
    const Eigen::VectorXd u = s.u + t * acceleration;
    return (lagrangian(d, q, u + unit) - lagrangian(d, q, u - unit)) / 2;
  };
  return rate(momentum) - rate([&](double t) { return lagrangian(d, s.q + t * unit, s.u); });
}
/// Differences of differences: rounding 1e-16/h² = 1e-10 times numbers up to ten.
constexpr double second_difference_bound = 1e-8;

}  // namespace

TEST_CASE("Tippe-top, Euler angles: its terms by differences", "[system]") {
  for (const TippeTopData& data : {solid, flat}) {
    const TippeTopEuler top(data, tippe_top_contacts(hertz, 0.3, 0.4));
    const TippeTopEuler coulomb(data, tippe_top_contacts(point));
    const TippeTopEuler smooth(data, tippe_top_contacts(NoFriction{}));
    for (const State& s : euler_states()) {
      check_terms(top, s);
      check_terms(coulomb, s);
      check_terms(smooth, s);
    }
  }
}

TEST_CASE("Tippe-top, Euler angles: gaps and contact velocities from the attitude alone", "[system]") {
  const TippeTopEuler top(solid, tippe_top_contacts(hertz, 0.3, 0.4));
  const double a[] = {solid.a1, solid.a2};
  const double r[] = {solid.r1, solid.r2};
  for (const State& s : euler_states()) {
    CHECK((top.axis(s.q) - attitude(s.q).col(2)).norm() <= 1e-15);
    CHECK((top.spin(s.q, s.u) - spin(s.q, s.u)).norm() <= difference_bound);
    for (const std::size_t i : {0, 1}) {
      const Vector3d arm = a[i] * attitude(s.q).col(2) - Vector3d(0, 0, r[i]);
      CHECK(std::abs(top.gap(i, 0, s.q) - (s.q[2] + arm[2])) <= 1e-15);
      const Vector3d fixed = attitude(s.q).transpose() * arm;
      const Vector3d velocity = rate([&](double t) -> Vector3d {
        const Eigen::VectorXd q = s.q + t * s.u;
        return q.head<3>() + attitude(q) * fixed;
      });
      ContactRows rows(6);
      top.contact_rows(i, 0, s.q, s.u, rows);
      CHECK(std::abs(rows.velocity[0] - velocity[2]) <= difference_bound);
      CHECK(std::abs(rows.velocity[1] - velocity[0]) <= difference_bound);
      CHECK(std::abs(rows.velocity[2] - velocity[1]) <= difference_bound);
      CHECK(std::abs(rows.velocity[3] - 0.4 * spin(s.q, s.u)[2]) <= difference_bound);
    }
  }
}

TEST_CASE("Tippe-top, Euler angles: Lagrange's equations", "[system]") {
  for (const TippeTopData& data : {solid, flat}) {
    const TippeTopEuler top(data, tippe_top_contacts(hertz, 0.3, 0.4));
    for (const State& s : euler_states()) {
      Eigen::VectorXd acceleration(6);
      top.free_acceleration(0, s.q, s.u, acceleration);
      Eigen::VectorXd generalised = Eigen::VectorXd::Zero(6);
      for (const std::size_t i : {0, 1}) {
        ContactRows rows(6);
        top.contact_rows(i, 0, s.q, s.u, rows);
        const Eigen::Vector4d lambda = generic(4, static_cast<double>(i));
        acceleration += rows.response * lambda;
        generalised += rows.directions * lambda;
      }
      for (int k = 0; k < 6; ++k) {
        CHECK(std::abs(euler_lagrange(data, s, acceleration, k) - generalised[k]) <= second_difference_bound);
      }
    }
  }
}

TEST_CASE("Tippe-top, Euler angles: inclination folded into [0, π]", "[system]") {
  const TippeTopEuler top({}, tippe_top_contacts(hertz));
  const auto at = [&](double theta) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(6);
    q[3] = theta;
    return top.inclination(q);
  };
  constexpr double pi = std::numbers::pi;
  CHECK(at(0) == 0);
  CHECK(at(0.3) == 0.3);
  CHECK(at(-0.3) == 0.3);
  CHECK(at(pi) == pi);
  CHECK(at(3.5) == Approx(2 * pi - 3.5).epsilon(1e-15));
  CHECK(at(7) == Approx(7 - 2 * pi).epsilon(1e-14));
}
