#include "contensou/scene/read_bodies.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "bodies_scene.hpp"

using namespace contensou;
using namespace contensou::test;
using Eigen::Vector3d;

TEST_CASE("Scene of bodies: every key arrives", "[scene]") {
  const Scene scene = changed({});
  const BodiesScene& bodies = bodies_of(scene);
  const BodiesData& data = bodies.data;
  CHECK(data.gravity == Vector3d(0, 1, -9.81));
  REQUIRE(data.bodies.size() == 9);

  const BodyData& top = data.bodies[0];
  CHECK((top.name == "top" && top.rotation == Rotation::free && top.mass == 2));
  CHECK(top.inertia == Vector3d(3, 4, 5));
  CHECK(top.orientation.coeffs() == Eigen::Vector4d(1, 0, 0, 0));  // x, y, z, w
  CHECK(top.velocity == Vector3d(1, 2, 3));
  CHECK(top.spin == Vector3d(4, 5, 6));
  CHECK((top.drag.linear == 0.5 && top.drag.angular == 0.25));
  REQUIRE(top.spheres.size() == 2);
  CHECK((top.spheres[0].name == "top.tip" && top.spheres[0].radius == 0.5));
  CHECK(top.spheres[0].centre == Vector3d(0, 0, 2));
  CHECK(top.spheres[1].centre.isZero(0));
  // Upside down, so the tip is lowest, at z - 2 - 0.5; the hull, at z - 1, has no contact with the floor.
  CHECK(top.position == Vector3d(0.5, 0.25, 2.5));

  const BodyData& puck = data.bodies[1];
  CHECK(puck.rotation == Rotation::upright);
  CHECK(puck.inertia[2] == 0.125);
  CHECK(puck.spin == Vector3d(0, 0, 3));
  CHECK((puck.base && puck.base->height == 0.25 && puck.base->name == "puck.base"));
  CHECK(puck.velocity.isZero(0));
  CHECK(!puck.drag.any());
  CHECK((data.bodies[2].rotation == Rotation::driven && data.bodies[2].spin == Vector3d(0, 0, 7)));
  CHECK(data.bodies[3].rotation == Rotation::none);

  REQUIRE(data.planes.size() == 5);
  CHECK((data.planes[0].name == "floor" && data.planes[0].normal == Vector3d::UnitZ()));
  CHECK(data.planes[1].normal.isApprox(Vector3d(0, 0.6, 0.8), 1e-15));
  CHECK(data.planes[1].offset == -50);
  CHECK((data.planes[2].name == "hall.west" && data.planes[2].normal == Vector3d::UnitX()));
  CHECK(data.planes[2].offset == -50);
  CHECK((data.planes[3].name == "hall.north" && data.planes[3].normal == -Vector3d::UnitY()));
  CHECK(data.planes[3].offset == -54);
  CHECK((data.planes[4].name == "hall.bottom" && data.planes[4].offset == -52));

  REQUIRE(data.loads.size() == 1);
  const LoadData& push = data.loads[0];
  CHECK(push.body == 1);
  CHECK((push.force == Vector3d(1, 2, 3) && push.torque == Vector3d(0, 0, 4)));
  CHECK(push.course.times == std::vector<double>{0, 1, 2});
  CHECK(push.course.factors == std::vector<double>{1, 0.5, 0});
  CHECK((push.course.frequency == 50 && push.course.phase == 0.5));

  REQUIRE(bodies.contacts.size() == 5);
  const ContactScene& contact = bodies.contacts[0];
  CHECK((contact.name == "top" && contact.pressure == "table" && contact.model == "ellipsoid"));
  CHECK(contact.table_radius == std::vector<double>{0, 0.5, 1});
  CHECK(contact.table_pressure == std::vector<double>{1, 1, 0});
  CHECK(scene.columns == std::vector<std::string>{"top.x", "pile.5.z", "gap_top", "slip_slide", "energy"});
}

TEST_CASE("Scene of bodies: what is not said is not there", "[scene]") {
  const Scene scene = changed(
      {{"scene.gravity", "body.top.orientation", "body.top.velocity", "body.top.spin", "body.top.linear_drag",
        "body.top.angular_drag", "body.puck.spin", "load", "balls.pile.jitter", "balls.pile.seed",
        "balls.pile.velocity", "balls.pile.spin", "output.columns", "outcome"},
       {"body.top.inertia=3"}});
  const BodiesData& data = bodies_of(scene).data;
  CHECK(data.gravity.isZero(0));
  const BodyData& top = data.bodies[0];
  CHECK(top.inertia == Vector3d(3, 3, 3));
  CHECK(top.orientation.coeffs() == Eigen::Vector4d(0, 0, 0, 1));
  CHECK((top.velocity.isZero(0) && top.spin.isZero(0) && !top.drag.any()));
  CHECK(top.position == Vector3d(0.5, 0.25, -1.5));  // the tip, at z + 2 - 0.5, is what has a contact
  CHECK(data.bodies[1].spin.isZero(0));
  CHECK(data.loads.empty());
  CHECK((data.bodies[4].velocity.isZero(0) && data.bodies[4].spin.isZero(0)));
  CHECK(scene.columns.empty());
  CHECK(bodies_of(changed({{}, {"scene.gravity=9.81"}})).data.gravity == Vector3d(0, 0, -9.81));
}

TEST_CASE("Scene of bodies: missing keys are named with the line of their table", "[scene]") {
  for (const char* text : {"scene.duration",
                           "body.top.mass",
                           "body.top.inertia",
                           "body.top.position",
                           "body.top.sphere.tip.radius",
                           "body.puck.inertia",
                           "body.puck.base.height",
                           "body.brush.spin",
                           "balls.pile.count",
                           "balls.pile.radius",
                           "balls.pile.mass",
                           "balls.pile.lower",
                           "balls.pile.spacing",
                           "balls.pile.across",
                           "balls.pile.seed",
                           "plane.floor.normal",
                           "plane.floor.offset",
                           "box.hall.lower",
                           "box.hall.upper",
                           "box.hall.sides",
                           "load.push.body",
                           "load.push.times",
                           "load.push.factors",
                           "contact.top.between",
                           "contact.top.law",
                           "contact.top.radius",
                           "contact.top.mu",
                           "contact.top.table_radius",
                           "contact.top.table_pressure",
                           "contact.slide.mu",
                           "outcome.end.column",
                           "outcome.through.value",
                           "outcome.third.event",
                           "outcome.third.contact",
                           "body.bead.rotation"}) {
    const std::string key = text;
    const std::string table = '[' + key.substr(0, key.rfind('.')) + ']';
    const auto place = static_cast<std::ptrdiff_t>(everything.find(table));
    const auto line = 1 + std::count(everything.begin(), everything.begin() + place, '\n');
    CHECK(check_refused({{{key}, {}}, {"f.toml:" + std::to_string(line) + ": " + key + " is missing"}}) ==
          "");
  }
  CHECK(check_refused({{{"load.push.force", "load.push.torque"}, {}}, {"load.push.force is missing"}}) == "");
  CHECK(check_refused({{{"scene.system"}, {}}, {"f.toml:1: scene.system is missing", "\"bodies\""}}) == "");
}

TEST_CASE("Scene of bodies: what makes no sense is refused", "[scene]") {
  const std::vector<Refused> cases{
      {{{}, {"body.top.mass=-1"}}, {"--set body.top.mass: -1", "> 0"}},
      {{{}, {"body.top.inertia=[1,1,2.1]"}}, {"--set body.top.inertia: [1,1,2.1] is of no body"}},
      {{{}, {"body.top.inertia=[1,-1,1]"}}, {"body.top.inertia", "holds -1"}},
      {{{}, {"body.top.inertia=0"}}, {"body.top.inertia: 0", "> 0"}},
      {{{}, {"body.top.inertia=[1,1]"}}, {"2 entries", "three numbers"}},
      {{{}, {"body.top.orientation=[1,0,0,0.1]"}}, {"body.top.orientation", "has length 1.00", "quaternion"}},
      {{{}, {"body.top.orientation=[0,0,0,0]"}}, {"has length 0"}},
      {{{}, {"body.top.orientation=[1e308,1e308,1e308,1e308]"}}, {"body.top.orientation", "length"}},
      {{{}, {"body.top.position=[0,0]"}}, {"2 entries", "three finite numbers"}},
      {{{}, {"body.top.position=[0,0,nan]"}}, {"holds nan"}},
      {{{}, {"body.top.position=[0,0,inf]"}}, {"holds inf"}},
      {{{}, {"body.top.position=[]"}}, {"0 entries"}},
      {{{}, {"body.top.position=[0,'a',1]"}}, {"is not an array of numbers"}},
      {{{}, {"body.top.position=7"}}, {"7 is not an array of numbers"}},
      {{{}, {"body.top.position=[0,0,1e308]", "body.top.sphere.tip.centre=[0,0,-1.7e308]"}}, {"body.top"}},
      {{{}, {"body.top.rotation=fixed"}}, {"\"fixed\" is unknown", "\"upright\""}},
      {{{}, {"body.top.linear_drag=-1"}}, {"body.top.linear_drag", ">= 0"}},
      {{{}, {"body.top.sphere.tip.radius=0"}}, {"body.top.sphere.tip.radius: 0"}},
      {{{}, {"body.top.sphere.radius=1"}}, {"body.top.sphere.radius: unknown key"}},
      {{{}, {"body.top.base={height=1}"}}, {"[body.top.base] is not of a body that is free"}},
      {{{}, {"body.puck.sphere.base={radius=0.1}"}}, {"has the base's name"}},
      {{{}, {"body.puck.spin=[0,0,1]"}}, {"body.puck.spin", "is not a number", "third axis"}},
      {{{}, {"body.puck.inertia=[1,1,1]"}}, {"body.puck.inertia", "is not a number"}},
      {{{}, {"body.brush.base={height=1}", "body.brush.spin=[0,1,7]"}}, {"body.brush.spin", "tilt the base"}},
      {{{}, {"body.brush.inertia=1"}}, {"body.brush.inertia: 1 is not used by rotation driven"}},
      {{{}, {"body.bead.spin=[0,0,1]"}}, {"body.bead.spin", "not used by rotation none"}},
      {{{}, {"body.bead.angular_drag=1"}}, {"not used by rotation none"}},
      {{{}, {"body.top.touching=top"}}, {"--set body.top.touching: \"top\" is no plane"}},
      {{{}, {"body.top.touching=hall"}}, {"is no plane"}},
      {{{}, {"body.top.touching=slope"}}, {"has no contact with top"}},
      {{{}, {"body.floor={rotation='none', mass=1, position=[0,0,0]}"}}, {"has the name of something else"}},
      {{{}, {"plane.floor.normal=[0,0,1.1]"}}, {"plane.floor.normal", "has length 1.1"}},
      {{{}, {"box.hall.upper=[53,54,-52]"}}, {"box.hall.upper", "is not above lower"}},
      {{{}, {"box.hall.sides=['left']"}}, {"names no side", "\"south\""}},
      {{{}, {"box.hall.sides=['west','west']"}}, {"names a side twice"}},
      {{{}, {"box.hall.sides=[]"}}, {"is not an array of strings"}},
      {{{}, {"load.push.body=pock"}}, {"load.push.body: \"pock\" is not in the scene"}},
      {{{}, {"load.push.body=pile.6"}}, {"is not in the scene"}},
      {{{}, {"load.push.body=brush"}}, {"f.toml:69: load.push.torque", "cannot turn brush"}},
      {{{}, {"load.push.times=[0,2,2]"}}, {"load.push.times", "does not increase"}},
      {{{}, {"load.push.factors=[1]"}}, {"load.push.factors", "1 entries", "3, as in times"}},
      {{{"load.push.frequency"}, {}}, {"load.push.phase: 0.5 is not used by a load without frequency"}},
      {{{}, {"scene.gravity=-1"}}, {"scene.gravity: -1", ">= 0"}},
      {{{}, {"scene.gravity=[0,1]"}}, {"scene.gravity", "2 entries"}},
      {{{}, {"scene.formulation=axis"}}, {"not used by system bodies"}},
      {{{"body", "balls", "contact", "load", "outcome", "output"}, {}}, {"there is no body", "[balls.NAME]"}},
      {{{}, {"top.mass=1"}}, {"--set top.mass: there is no [top]"}},
      {{{}, {"body.top.size=1"}}, {"--set body.top.size: unknown key", "one of angular_drag, inertia"}},
  };
  for (const Refused& refused : cases) CHECK(check_refused(refused) == "");
}

TEST_CASE("Scene of bodies: rounding of moments and of units is no error", "[scene]") {
  // A flat plate: 0.1 + 0.2 is 0.30000000000000004, and 0.3 - 0.1 less than 0.2.
  CHECK(refusal({{}, {"body.top.inertia=[0.1,0.2,0.30000000000000004]"}}).empty());
  CHECK(refusal({{}, {"body.top.inertia=[0.3,0.1,0.2]"}}).empty());
  CHECK(refusal({{}, {"body.top.orientation=[0.70710678119,0,0,0.70710678119]"}}).empty());
  const Scene scene = changed({{}, {"body.top.orientation=[0.70710678119,0,0,0.70710678119]"}});
  CHECK(std::abs(bodies_of(scene).data.bodies[0].orientation.norm() - 1) <
        2 * std::numeric_limits<double>::epsilon());
}
