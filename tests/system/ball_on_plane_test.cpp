#include "contensou/system/ball_on_plane.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "differences.hpp"
#include "small_contacts.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

const BallOnPlaneData inclined{.m = 1.3, .r = 0.7, .g = 2, .tilt = 0.4};

}  // namespace

TEST_CASE("Ball on a plane: its terms by differences", "[system]") {
  for (const SystemContact& contact : {smooth_floor(), coulomb_floor(), hertz_floor()}) {
    const BallOnPlane ball(inclined, contact);
    check_terms(ball, generic_state(ball));
  }
}

TEST_CASE("Ball on a plane: contact velocity and forces as in space", "[system]") {
  const BallOnPlane ball(inclined, hertz_floor(0.3, 0.4));
  const State s = generic_state(ball);
  const Vector3d arm(0, 0, -0.7);  // centre to contact point
  const Vector3d spin = s.u.tail<3>();
  const Vector3d velocity = Vector3d(s.u.head<3>()) + spin.cross(arm);
  ContactRows rows(6);
  ball.contact_rows(0, 0, s.q, s.u, rows);
  CHECK(std::abs(rows.velocity[0] - velocity[2]) <= 1e-16);
  CHECK(std::abs(rows.velocity[1] - velocity[0]) <= 1e-15);
  CHECK(std::abs(rows.velocity[2] - velocity[1]) <= 1e-15);
  CHECK(rows.velocity[3] == 0.4 * spin[2]);
  CHECK(ball.gap(0, 0, s.q) == s.q[2] - 0.7);

  // a force F at the contact point and a torque about the normal
  const Vector3d force(0.4, -0.9, 1.1);
  const double torque = 0.4 * 0.8;
  const Eigen::VectorXd change = rows.response * Eigen::Vector4d(force[2], force[0], force[1], 0.8);
  CHECK((1.3 * change.head<3>() - force).norm() <= 1e-15);
  CHECK((0.4 * 1.3 * 0.7 * 0.7 * change.tail<3>() - arm.cross(force) - Vector3d(0, 0, torque)).norm() <=
        1e-15);
}

TEST_CASE("Ball on a plane: gravity and its potential", "[system]") {
  const BallOnPlane ball(inclined, smooth_floor());
  const State s = generic_state(ball);
  Eigen::VectorXd h(6);
  ball.force(0, s.q, s.u, h);
  for (int k = 0; k < 3; ++k) {
    const double slope =
        rate([&](double t) { return ball.potential_energy(s.q + t * Eigen::VectorXd::Unit(3, k)); });
    CHECK(std::abs(h[k] + slope) <= difference_bound);
  }
  CHECK(std::abs(h.norm() - 1.3 * 2) <= 1e-15);
  CHECK(h[0] > 0);  // down towards +x
}

TEST_CASE("Ball on a plane: bad data give one clear line", "[system]") {
  const auto says = [](const BallOnPlaneData& data, const std::string& message) {
    CHECK_THROWS_WITH(BallOnPlane(data, hertz_floor()), "ball on plane: " + message);
  };
  says({.m = 0}, "m 0, expected a number > 0");
  says({.r = NAN}, "r nan, expected a number > 0");
  says({.g = -1}, "g -1, expected a number >= 0");
  says({.tilt = -2}, "tilt -2, expected a number from -pi/2 to pi/2");
}
