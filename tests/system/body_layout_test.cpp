#include "contensou/system/body_layout.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies_examples.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

BodiesData four() {
  BodiesData data;
  data.gravity = {1, 2, -3};
  for (const Rotation rotation : {Rotation::none, Rotation::free, Rotation::upright, Rotation::driven}) {
    BodyData body = ball("body", 2, 0.5, 0);
    body.rotation = rotation;
    body.inertia = {0.7, 1.1, 1.5};
    body.position = {1, -2, 3};
    body.velocity = {0.1, 0.2, 0.3};
    body.orientation = Eigen::AngleAxisd(0.9, Vector3d(1, 2, 2) / 3);
    if (rotation != Rotation::none) body.spin = 4 * (body.orientation * Vector3d::UnitZ());
    data.bodies.push_back(body);
  }
  set_rules(data, 1, {});
  return data;
}

}  // namespace

TEST_CASE("Layout: sizes, and where bodies stand", "[system][bodies]") {
  const BodiesData data = four();
  const BodyLayout layout(data);
  CHECK(layout.coordinates() == 3 + 7 + 4 + 3);
  CHECK(layout.velocities() == 3 + 6 + 4 + 3);
  CHECK(layout.first_coordinate(3) == 14);
  CHECK(layout.first_velocity(2) == 9);
}

TEST_CASE("Layout: the start says what the data say", "[system][bodies]") {
  const BodiesData data = four();
  const BodyLayout layout(data);
  const State s = layout.start();
  CHECK(s.t == 0);
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(layout.position(i, s.q) == data.bodies[i].position);
    CHECK(layout.velocity(i, s.u) == data.bodies[i].velocity);
    CHECK(layout.orientation(i, 0, s.q).angularDistance(data.bodies[i].orientation) <= 1e-7);
    CHECK((layout.spin(i, 0, s.q, s.u) - data.bodies[i].spin).norm() <= 1e-14);
  }
}

TEST_CASE("Layout: a body turns by its spin", "[system][bodies]") {
  // About the third axis, as all here: that stays where it is and the first one turns about it.
  const BodiesData data = four();
  const BodyLayout layout(data);
  State s = layout.start();
  const double t = 0.2;
  s.q[layout.first_coordinate(2) + 3] = 4 * t;
  for (const std::size_t i : {2, 3}) {
    const Eigen::Quaterniond now = layout.orientation(i, t, s.q);
    const Vector3d axis = data.bodies[i].orientation * Vector3d::UnitZ();
    const Vector3d first = data.bodies[i].orientation * Vector3d::UnitX();
    CHECK((now * Vector3d::UnitZ() - axis).norm() <= 1e-15 * 4);
    CHECK((now * Vector3d::UnitX() - std::cos(0.8) * first - std::sin(0.8) * axis.cross(first)).norm() <=
          1e-15 * 4);
  }
}

TEST_CASE("Layout: energies", "[system][bodies]") {
  const BodiesData data = four();
  const BodyLayout layout(data);
  const State s = layout.start();
  // ½ m v² four times, and ½ I₃ ω² of the free and the upright body; a driven one's rotation is none.
  CHECK(std::abs(layout.kinetic_energy(s.u) - (4 * 0.14 + 2 * 0.75 * 16)) <= 1e-13);
  CHECK(std::abs(layout.potential_energy(s.q) - 4 * 2 * -(1 - 4 - 9)) <= 1e-13);
}
