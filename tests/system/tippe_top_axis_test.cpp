#include "contensou/system/tippe_top_axis.hpp"

#include <Eigen/Geometry>
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

/// Generic states, and upright and inverted ones, where Euler angles end.
std::vector<State> states() {
  std::vector<State> result;
  for (const Vector3d& e : {Vector3d(0.3, -0.5, 0.7), Vector3d(-0.6, 0.2, -0.4), Vector3d(0, 0, 1),
                            Vector3d(0, 0, -1), Vector3d(1, 0, 0)}) {
    State s{0.2, Eigen::VectorXd(6), Eigen::VectorXd(6)};
    s.q << 0.3, -0.2, 1.4, e.normalized();
    s.u << 0.5, -0.8, 0.3, 1.3, -0.9, 1.7;
    result.push_back(s);
  }
  return result;
}

/// A rigid body in space, knowing nothing of the system's terms: where its points are when it has turned
/// with ω(t) = ω + ω̇t (to second order in t).
struct Body {
  State s;
  Eigen::VectorXd acceleration = Eigen::VectorXd::Zero(6);

  Vector3d spin(double t) const { return s.u.tail<3>() + t * acceleration.tail<3>(); }
  Matrix3d turn(double t) const {
    const Vector3d angle = t * s.u.tail<3>() + t * t / 2 * acceleration.tail<3>();
    return Eigen::AngleAxisd(angle.norm(), angle.normalized()).toRotationMatrix();
  }
  Vector3d centre(double t) const {
    return s.q.head<3>() + t * s.u.head<3>() + t * t / 2 * acceleration.head<3>();
  }
};

}  // namespace

TEST_CASE("Tippe-top, axis: its terms by differences", "[system]") {
  for (const TippeTopData& data : {solid, flat}) {
    const TippeTopAxis top(data, tippe_top_contacts(hertz, 0.3, 0.4));
    const TippeTopAxis coulomb(data, tippe_top_contacts(point));
    const TippeTopAxis smooth(data, tippe_top_contacts(NoFriction{}));
    for (const State& s : states()) {
      check_terms(top, s);
      check_terms(coulomb, s);
      check_terms(smooth, s);
    }
  }
}

TEST_CASE("Tippe-top, axis: gaps and contact velocities from the geometry", "[system]") {
  const TippeTopAxis top(solid, tippe_top_contacts(hertz, 0.3, 0.4));
  const double a[] = {solid.a1, solid.a2};
  const double r[] = {solid.r1, solid.r2};
  for (const State& s : states()) {
    const Body body{s};
    for (const std::size_t i : {0, 1}) {
      const Vector3d sphere = a[i] * s.q.tail<3>();
      CHECK(std::abs(top.gap(i, 0, s.q) - (s.q[2] + sphere[2] - r[i])) <= 1e-15);
      const Vector3d arm = sphere - Vector3d(0, 0, r[i]);
      const Vector3d velocity =
          rate([&](double t) -> Vector3d { return body.centre(t) + body.turn(t) * arm; });
      const Matrix3d turning = rate([&](double t) -> Matrix3d { return body.turn(t); });
      ContactRows rows(6);
      top.contact_rows(i, 0, s.q, s.u, rows);
      CHECK(std::abs(rows.velocity[0] - velocity[2]) <= difference_bound);
      CHECK(std::abs(rows.velocity[1] - velocity[0]) <= difference_bound);
      CHECK(std::abs(rows.velocity[2] - velocity[1]) <= difference_bound);
      CHECK(std::abs(rows.velocity[3] - 0.4 * turning(1, 0)) <= difference_bound);
      CHECK(rows.drift[3] == 0);
    }
    // q̇: where the symmetry axis goes
    Eigen::VectorXd rates(6);
    top.coordinate_rates(s.q, s.u, rates);
    const Vector3d going = rate([&](double t) -> Vector3d { return body.turn(t) * s.q.tail<3>(); });
    CHECK((rates.head<3>() - s.u.head<3>()).norm() == 0);
    CHECK((rates.tail<3>() - going).norm() <= difference_bound);
  }
}

TEST_CASE("Tippe-top, axis: momentum and angular momentum change by forces and torques", "[system]") {
  for (const TippeTopData& data : {solid, flat}) {
    const TippeTopAxis top(data, tippe_top_contacts(hertz, 0.3, 0.4));
    const double a[] = {data.a1, data.a2};
    const double r[] = {data.r1, data.r2};
    for (const State& s : states()) {
      Eigen::VectorXd acceleration(6);
      top.free_acceleration(0, s.q, s.u, acceleration);
      Vector3d force(0, 0, -data.m * data.g);
      Vector3d torque(0, 0, 0);
      for (const std::size_t i : {0, 1}) {
        const Eigen::Vector4d lambda = generic(4, static_cast<double>(i));
        ContactRows rows(6);
        top.contact_rows(i, 0, s.q, s.u, rows);
        acceleration += rows.response * lambda;
        const Vector3d push(lambda[1], lambda[2], lambda[0]);
        force += push;
        torque += (a[i] * s.q.tail<3>() - Vector3d(0, 0, r[i])).cross(push) + Vector3d(0, 0, 0.4 * lambda[3]);
      }
      const Body body{s, acceleration};
      Matrix3d frame;
      frame.col(2) = s.q.tail<3>();
      frame.col(0) = frame.col(2).unitOrthogonal();
      frame.col(1) = frame.col(2).cross(frame.col(0));
      const Matrix3d inertia = frame * Vector3d(data.i1, data.i1, data.i3).asDiagonal() * frame.transpose();
      const Vector3d change = rate([&](double t) -> Vector3d {
        return body.turn(t) * inertia * body.turn(t).transpose() * body.spin(t);
      });
      CHECK((data.m * acceleration.head<3>() - force).norm() <= 1e-13);
      CHECK((change - torque).norm() <= difference_bound);
    }
  }
}

TEST_CASE("Tippe-top, axis: restored to unit length, once", "[system]") {
  const TippeTopAxis top({}, tippe_top_contacts(hertz));
  Eigen::VectorXd q = states()[0].q;
  q.tail<3>() *= 1.001;
  top.restore(q);
  CHECK(std::abs(q.tail<3>().norm() - 1) <= 3e-16);
  CHECK((q.tail<3>() - states()[0].q.tail<3>()).norm() <= 3e-16);
  const Eigen::VectorXd once = q;
  top.restore(q);
  CHECK((q - once).norm() == 0);
  CHECK(top.inclination(top.start(0, 180).q) == 0);
  CHECK(top.inclination(top.start(std::numbers::pi, 180).q) == Approx(std::numbers::pi).epsilon(1e-15));
}
