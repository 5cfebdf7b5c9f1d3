// Motions of rigid bodies beside those of the systems made for one thing each, and beside closed forms.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "bodies_examples.hpp"
#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/free_body.hpp"
#include "contensou/system/point_mass.hpp"
#include "contensou/system/sliding_disc.hpp"
#include "tippe_top_states.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

struct Run {
  State end;
  RunReport report;
};

Run run(const MechanicalSystem& system, const State& start, double t_end, double tolerance) {
  Run r{start, {}};
  IntegratorOptions options;
  options.tolerance = tolerance;
  r.report = integrate(system, r.end, t_end, options);
  CHECK(r.report.status == RunStatus::finished);
  CHECK(r.report.message.empty());
  return r;
}

/// The first `count` events, or all.
void check_same_events(const RunReport& a, const RunReport& b, double time, std::size_t count = 0) {
  if (count == 0) REQUIRE(a.events.size() == b.events.size());
  if (count == 0) count = a.events.size();
  REQUIRE(std::min(a.events.size(), b.events.size()) >= count);
  for (std::size_t k = 0; k < count; ++k) {
    CAPTURE(k, name(a.events[k].kind), name(b.events[k].kind), a.events[k].t - b.events[k].t);
    CHECK(a.events[k].kind == b.events[k].kind);
    CHECK(a.events[k].contact == b.events[k].contact);
    CHECK(std::abs(a.events[k].t - b.events[k].t) <= time);
  }
}

/// One body on the floor, surface 0 against 1.
BodiesData on_floor(const BodyData& body, const SystemContact& law, const Vector3d& gravity) {
  BodiesData data;
  data.gravity = gravity;
  data.bodies = {body};
  data.planes = {floor_plane(1)};
  data.rules = {law};
  set_rules(data, 2, {{0, 1}});
  return data;
}

/// One body of LG03 5.4 with two spheres, as TippeTopAxis::start puts it.
BodiesData tippe_top(const TippeTopData& top, const TippeTopAxis& axis, const State& start) {
  BodiesData data;
  data.gravity = {0, 0, -top.g};
  BodyData body;
  body.name = "top";
  body.rotation = Rotation::free;
  body.mass = top.m;
  body.inertia = {top.i1, top.i1, top.i3};
  body.spheres = {{"body", {0, 0, top.a1}, top.r1, 0}, {"tip", {0, 0, top.a2}, top.r2, 1}};
  body.position = start.q.head<3>();
  body.velocity = start.u.head<3>();
  body.orientation = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis.axis(start.q));
  body.spin = start.u.tail<3>();
  data.bodies = {body};
  data.planes = {floor_plane(2)};
  data.rules = axis.contacts();
  set_rules(data, 3, {{0, 2}, {1, 2}});
  return data;
}

}  // namespace

TEST_CASE("Rigid bodies: the tippe-top moves as the dedicated one does", "[system][bodies]") {
  const TippeTopData top;
  const TippeTopAxis axis(top, tippe_top_contacts(hertz));
  const State start = axis.start(0.1, 180);
  const RigidBodies bodies(tippe_top(top, axis, start));
  CHECK(bodies.length_scale() == axis.length_scale());
  constexpr double t_end = 2.2;  // the tip touches at 1.37 s, and the body leaves
  const Run expected = run(axis, start, t_end, 1e-12);
  const Run obtained = run(bodies, bodies.start(), t_end, 1e-12);
  REQUIRE(expected.report.events.size() > 1);
  check_same_events(obtained.report, expected.report, 1e-8);
  const Vector3d direction = bodies.layout().orientation(0, t_end, obtained.end.q) * Vector3d::UnitZ();
  const Vector3d spin = bodies.layout().spin(0, t_end, obtained.end.q, obtained.end.u);
  const double position = (obtained.end.q.head<3>() - expected.end.q.head<3>()).norm();
  const double tilt = (direction - axis.axis(expected.end.q)).norm();
  const double velocity = (obtained.end.u.head<3>() - expected.end.u.head<3>()).norm();
  const double turning = (spin - expected.end.u.tail<3>()).norm();
  CAPTURE(position, tilt, velocity, turning);
  CHECK(position <= 1e-9);
  CHECK(tilt <= 1e-7);
  CHECK(velocity <= 1e-8);
  CHECK(turning <= 1e-5);
}

TEST_CASE("Rigid bodies: a point mass that slides, sticks, or bounces, as the dedicated one",
          "[system][bodies]") {
  // Gravity of an inclined plane and a force along it; what is at z of the plane is here at z + r.
  constexpr double m = 0.7, g = 9.81, tilt = 0.2, r = 0.25, tolerance = 1e-11;
  for (const double mu : {0.1, 0.5}) {
    SystemContact law = coulomb_floor(mu);
    law.restitution = 0.6;
    const PointMass point({.m = m, .g = g, .tilt = tilt, .force_x = -0.4, .force_y = 0.3}, law);
    State start{0, Eigen::Vector3d(0, 0, 0.1), Eigen::Vector3d(1.5, -0.4, 0.2)};
    BodyData body = ball("point", m, r, 0);
    body.rotation = Rotation::none;
    body.position = start.q.head<3>() + Vector3d(0, 0, r);
    body.velocity = start.u.head<3>();
    BodiesData data = on_floor(body, law, {g * std::sin(tilt), 0, -g * std::cos(tilt)});
    data.loads = {{"pull", 0, {-0.4, 0.3, 0}, {0, 0, 0}, {}}};
    const RigidBodies bodies(data);
    const Run expected = run(point, start, 1.5, tolerance);
    const Run obtained = run(bodies, bodies.start(), 1.5, tolerance);
    // The two have other scales, and so another last bounce that is not summed.
    check_same_events(obtained.report, expected.report, 1e-8, 30);
    CHECK((obtained.end.q.head<3>() - Vector3d(0, 0, r) - expected.end.q.head<3>()).norm() <= 1e-8);
    CHECK((obtained.end.u.head<3>() - expected.end.u.head<3>()).norm() <= 1e-8);
    CHECK(std::abs(obtained.report.dissipated[0].total() - expected.report.dissipated[0].total()) <= 1e-8);
  }
}

TEST_CASE("Rigid bodies: a ball that slides, rolls and spins, as the dedicated one", "[system][bodies]") {
  constexpr double m = 0.17, r = 0.3, g = 9.81, tilt = 0.05, tolerance = 1e-12;
  const SystemContact law = hertz_floor(0.3, 0.02);
  const BallOnPlane dedicated({.m = m, .r = r, .g = g, .tilt = tilt}, law);
  State start{0, Vector3d(0, 0, r), Eigen::VectorXd(6)};
  start.u << 2, 0.5, 0, 3, -1, 40;
  BodyData body = ball("ball", m, r, 0);
  body.position = start.q.head<3>();
  body.velocity = start.u.head<3>();
  body.spin = start.u.tail<3>();
  body.orientation = Eigen::AngleAxisd(1.2, Vector3d(1, -2, 0.5).normalized());
  const RigidBodies bodies(on_floor(body, law, {g * std::sin(tilt), 0, -g * std::cos(tilt)}));
  for (const double t_end : {0.2, 3.0}) {  // sliding; rolling, the spin still there
    const Run expected = run(dedicated, start, t_end, tolerance);
    const Run obtained = run(bodies, bodies.start(), t_end, tolerance);
    check_same_events(obtained.report, expected.report, 1e-8);
    CHECK((obtained.end.q.head<3>() - expected.end.q.head<3>()).norm() <= 1e-9);
    CHECK((obtained.end.u.head<3>() - expected.end.u.head<3>()).norm() <= 1e-9);
    const Vector3d spin = bodies.layout().spin(0, t_end, obtained.end.q, obtained.end.u);
    CHECK((spin - expected.end.u.tail<3>()).norm() <= 1e-8);
  }
}

TEST_CASE("Rigid bodies: a disc on its base, as the dedicated one", "[system][bodies]") {
  constexpr double m = 2, g = 9.81, radius = 0.1, height = 0.03;
  const SystemContact law = uniform_floor(0.2, radius);
  const SlidingDisc dedicated({.m = m, .i = m * radius * radius / 2, .g = g}, law);
  const State start{0, Eigen::VectorXd::Zero(4), Eigen::Vector4d(0.6, -0.2, 0, 15)};
  BodyData disc;
  disc.name = "disc";
  disc.rotation = Rotation::upright;
  disc.mass = m;
  disc.inertia = {0, 0, m * radius * radius / 2};
  disc.base = BaseData{"base", height, 0};
  disc.position = {0, 0, height};
  disc.velocity = {0.6, -0.2, 0};
  disc.spin = {0, 0, 15};
  const RigidBodies bodies(on_floor(disc, law, {0, 0, -g}));
  CHECK(bodies.length_scale() == dedicated.length_scale());
  const Run expected = run(dedicated, start, 1, 1e-10);
  const Run obtained = run(bodies, bodies.start(), 1, 1e-10);
  REQUIRE(expected.report.events.size() == 1);
  check_same_events(obtained.report, expected.report, 1e-9);
  CHECK((obtained.end.q.head<4>() - Eigen::Vector4d(0, 0, height, 0) - expected.end.q.head<4>()).norm() <=
        1e-9);
  CHECK(std::abs(obtained.report.dissipated[0].drilling - expected.report.dissipated[0].drilling) <= 1e-9);
}

TEST_CASE("Rigid bodies: a free body tumbles as the dedicated one, and flies", "[system][bodies]") {
  const FreeBody dedicated({.i1 = 0.7, .i2 = 1.1, .i3 = 1.5});
  BodiesData data;
  BodyData body;
  body.name = "free";
  body.rotation = Rotation::free;
  body.mass = 2;
  body.inertia = {0.7, 1.1, 1.5};
  body.orientation = Eigen::Quaterniond(0.5, -0.3, 0.7, 0.4).normalized();
  body.velocity = {1, -2, 0.5};
  body.spin = body.orientation * Vector3d(0.9, -1.3, 0.6);
  data.bodies = {body};
  data.rule.resize(0, 0);
  const RigidBodies bodies(data);
  const State start = bodies.start();
  const State turning{0, start.q.tail<4>(), start.u.tail<3>()};
  const Run expected = run(dedicated, turning, 10, 1e-12);
  const Run obtained = run(bodies, start, 10, 1e-12);
  CHECK((obtained.end.q.tail<4>() - expected.end.q.head<4>()).norm() <= 1e-9);
  CHECK((obtained.end.u.tail<3>() - expected.end.u.head<3>()).norm() <= 1e-9);
  CHECK((obtained.end.q.head<3>() - Vector3d(10, -20, 5)).norm() <= 1e-12);
  CHECK(obtained.report.dissipated.empty());
  CHECK(obtained.report.work.empty());
}
