#include "contensou/system/rigid_bodies.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies_examples.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

/// Four bodies, one of each kind, that touch a tilted and a level plane and each other in all ways there are,
/// with spheres off their centres; all numbers of order one.
BodiesData all_kinds(const SystemContact& law) {
  BodiesData data;
  data.gravity = {0.3, -0.4, -2};
  BodyData free = ball("free", 1.3, 0.5, 0);
  free.inertia = {0.7, 1.1, 1.5};
  free.spheres = {{"one", {0.3, -0.2, 0.4}, 0.5, 0}, {"two", {-0.1, 0.6, 0.2}, 0.3, 0}};
  BodyData upright = ball("upright", 0.8, 0.4, 0);
  upright.rotation = Rotation::upright;
  upright.spheres[0].centre = {0.4, 0.1, -0.3};
  upright.orientation = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized());
  BodyData driven = ball("driven", 1.1, 0.6, 0);
  driven.rotation = Rotation::driven;
  driven.spheres[0].centre = {-0.2, 0.3, 0.5};
  driven.spin = {0.4, -0.9, 1.2};
  driven.orientation = Eigen::AngleAxisd(-1.1, Vector3d(0, 1, 1).normalized());
  BodyData still = ball("still", 0.9, 0.2, 0);
  still.rotation = Rotation::none;
  free.position = {2, 0, 0};
  driven.position = {0, 2, 0};
  still.position = {0, 0, 3};
  data.bodies = {free, upright, driven, still};
  data.planes = {{"level", Vector3d::UnitZ(), -3, 1}, {"tilted", Vector3d(1, -2, 2) / 3, -2.5, 2}};
  // A point that cannot spin does not drill: the one of kind none is a surface of its own.
  data.bodies[3].spheres[0].surface = 3;
  data.rules = {named(law, "bodies"), named(law, "level"), named(law, "tilted"),
                named(rows(law.friction) > 3 ? coulomb_floor() : law, "still")};
  set_rules(data, 4, {{0, 0}, {0, 1}, {0, 2}, {3, 1}});
  data.rule(0, 3) = data.rule(3, 0) = 0;
  return data;
}

State apart(const RigidBodies& system) {
  State s = generic_state(system);
  s.q += 0.3 * system.start().q;
  system.restore(s.q);
  return s;
}

}  // namespace

TEST_CASE("Rigid bodies: terms of all kinds by differences", "[system][bodies]") {
  for (const SystemContact& law : {smooth_floor(), coulomb_floor(), hertz_floor()}) {
    const RigidBodies system(all_kinds(law));
    // 4 spheres on 2 planes, 5 pairs of them in different bodies; "still" on 1 plane and against 4 spheres.
    CHECK(system.contacts().size() == 8 + 5 + 1 + 4);
    check_terms(system, apart(system));
  }
}

TEST_CASE("Rigid bodies: terms with drag and loads by differences", "[system][bodies]") {
  BodiesData data = all_kinds(hertz_floor());
  data.bodies[0].drag = {0.3, 0.2};
  data.bodies[1].drag = {0, 0.4};
  data.bodies[3].drag = {0.6, 0};
  data.loads = {{"push", 0, {0.4, 0.2, -0.3}, {0.5, -0.6, 0.2}, {}},
                {"turn", 1, {0.1, 0, 0.2}, {0.3, 0.4, -0.5}, {{0, 1}, {0.5, 2}, 0.3, 0.2}},
                {"shake", 2, {-0.3, 0.7, 0.1}, {0, 0, 0}, {{}, {}, 0.5, 0}},
                {"swing", 0, {0, 0, 0.2}, {0.1, 0.7, -0.2}, {{}, {}, 0, 0.4}},
                {"lift", 1, {0, 0, 0.3}, {0, 0.1, 0.2}, {}}};
  const RigidBodies system(data);
  CHECK(system.works() == std::vector<std::string>{"air drag", "load push", "load turn", "load shake",
                                                   "load swing", "load lift"});
  check_terms(system, apart(system));
}

TEST_CASE("Rigid bodies: quaternions restored, scales, lengths", "[system][bodies]") {
  const RigidBodies system(all_kinds(coulomb_floor()));
  State s = system.start();
  const Eigen::VectorXd once = s.q;
  s.q.segment<4>(3) *= 1.001;
  system.restore(s.q);
  CHECK((s.q - once).norm() <= 3e-16);
  const Eigen::VectorXd restored = s.q;
  system.restore(s.q);
  CHECK((s.q - restored).norm() == 0);
  // The farthest that a sphere reaches is the driven body's.
  CHECK(system.length_scale() == Approx(Vector3d(-0.2, 0.3, 0.5).norm() + 0.6).epsilon(1e-15));
  Eigen::VectorXd scales(system.coordinates());
  system.coordinate_scales(scales);
  CHECK(scales[2] == system.length_scale());
  CHECK(scales[3] == 1);
  CHECK(scales[10] == 1);
  BodiesData far = all_kinds(coulomb_floor());
  far.bodies[3].position[0] = -640;
  CHECK(RigidBodies(far).length_scale() == 20);
}

TEST_CASE("Rigid bodies: what is absent has no account", "[system][bodies]") {
  const RigidBodies system(all_kinds(coulomb_floor()));
  CHECK(system.works().empty());
  CHECK(system.driven());
  BodiesData still = all_kinds(coulomb_floor());
  still.bodies[2].spin.setZero();
  CHECK(!RigidBodies(still).driven());
}
