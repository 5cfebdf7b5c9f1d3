#include "contensou/system/body_data.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies_examples.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

BodiesData valid() {
  BodiesData data;
  data.gravity = {0, 0, -9.81};
  data.bodies = {ball("ball", 1, 0.5, 0)};
  BodyData disc = ball("disc", 1, 0.5, 0);
  disc.rotation = Rotation::upright;
  disc.inertia = {0, 0, 0.1};
  disc.spheres.clear();
  disc.base = BaseData{"base", 0.1, 0};
  data.bodies.push_back(disc);
  data.planes = {floor_plane(1)};
  data.loads = {{"push", 0, {1, 0, 0}, {0, 1, 0}, {}}};
  data.rules = {smooth_floor()};
  set_rules(data, 2, {{0, 1}});
  return data;
}

/// What require_valid says of valid() with one thing changed.
template <class Change>
std::string complaint(const Change& change) {
  BodiesData data = valid();
  change(data);
  try {
    require_valid(data);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Bodies: what makes no sense is said in one line", "[system][bodies]") {
  using D = BodiesData;
  CHECK(complaint([](D&) {}).empty());
  CHECK(complaint([](D& d) { d.gravity[1] = INFINITY; }) == "bodies: gravity inf, expected a finite number");
  CHECK(complaint([](D& d) { d.bodies[0].mass = -1; }) == "body ball: mass -1, expected a number > 0");
  CHECK(complaint([](D& d) { d.bodies[0].inertia[1] = 0; }) == "body ball: inertia 0, expected a number > 0");
  CHECK(complaint([](D& d) {
          d.bodies[0].inertia = {1, 2, 4};
        }) == "body ball: inertia 4, expected at most the sum of the other two moments");
  CHECK(complaint([](D& d) { d.bodies[0].inertia = {0.1, 0.2, 0.1 + 0.2}; }).empty());  // flat
  CHECK(complaint([](D& d) { d.bodies[1].inertia[2] = NAN; }) ==
        "body disc: inertia nan, expected a number > 0");
  CHECK(complaint([](D& d) { d.bodies[0].drag.linear = -2; }) ==
        "body ball: linear drag -2, expected a number >= 0");
  CHECK(complaint([](D& d) { d.bodies[0].drag.angular = -2; }) ==
        "body ball: angular drag -2, expected a number >= 0");
  CHECK(complaint([](D& d) { d.bodies[0].position[0] = NAN; }) ==
        "body ball: position nan, expected a finite number");
  CHECK(complaint([](D& d) { d.bodies[0].velocity[0] = NAN; }) ==
        "body ball: velocity nan, expected a finite number");
  CHECK(complaint([](D& d) { d.bodies[0].spin[0] = NAN; }) ==
        "body ball: spin nan, expected a finite number");
  CHECK(complaint([](D& d) { d.bodies[0].orientation.w() = 2; }) ==
        "body ball: orientation of length 2, expected length 1");
  CHECK(complaint([](D& d) { d.bodies[0].spheres[0].centre[2] = NAN; }) ==
        "body ball: centre of a sphere nan, expected a finite number");
  CHECK(complaint([](D& d) { d.bodies[0].spheres[0].radius = 0; }) ==
        "body ball: radius of a sphere 0, expected a number > 0");
  CHECK(complaint([](D& d) { d.bodies[1].base->height = -0.5; }) ==
        "body disc: height of the base -0.5, expected a number >= 0");
  CHECK(complaint([](D& d) {
          d.bodies[0].base = BaseData{"base", 0.1, 0};
        }) == "body ball: has a base, expected rotation upright or driven");
  CHECK(complaint([](D& d) {
          d.bodies[1].spin = {3, 0, 1};
        }) == "body disc: spin across the third axis 3, expected 0 where it stays upright");
  CHECK(complaint([](D& d) {
          d.bodies[1].rotation = Rotation::none;
          d.bodies[1].base.reset();
          d.bodies[1].spin = {0, 0, 2};
        }) == "body disc: spin 2, expected 0 where it does not turn");
}

TEST_CASE("Bodies: planes, loads and rules that make no sense", "[system][bodies]") {
  using D = BodiesData;
  CHECK(complaint([](D& d) {
          d.planes[0].normal = {0, 0, 2};
        }) == "plane floor: normal of length 2, expected length 1");
  CHECK(complaint([](D& d) { d.planes[0].offset = INFINITY; }) ==
        "plane floor: offset inf, expected a finite number");
  CHECK(complaint([](D& d) { d.loads[0].body = 2; }) == "load push: body 2, expected the index of a body");
  CHECK(complaint([](D& d) { d.loads[0].force[2] = NAN; }) ==
        "load push: force nan, expected a finite number");
  CHECK(complaint([](D& d) { d.loads[0].torque[2] = NAN; }) ==
        "load push: torque nan, expected a finite number");
  CHECK(complaint([](D& d) { d.bodies[0].rotation = Rotation::driven; }) ==
        "load push: torque 1, expected 0 on a body that does not turn, or as it is told");
  CHECK(complaint([](D& d) { d.loads[0].course.frequency = -1; }) ==
        "load push: frequency -1, expected a number >= 0");
  CHECK(complaint([](D& d) { d.loads[0].course.phase = NAN; }) ==
        "load push: phase nan, expected a finite number");
  CHECK(complaint([](D& d) {
          d.loads[0].course.times = {0, 1};
        }) == "load push: number of factors 0, expected as many as times");
  CHECK(complaint([](D& d) {
          d.loads[0].course = {{0, 1, 1}, {1, 2, 3}, 0, 0};
        }) == "load push: time 1, expected increasing times");
  CHECK(complaint([](D& d) {
          d.loads[0].course = {{0, 1}, {1, NAN}, 0, 0};
        }) == "load push: factor nan, expected a finite number");
  CHECK(complaint([](D& d) { d.bodies[0].spheres[0].surface = 2; }) ==
        "bodies: surface 2, expected an index of the table of rules");
  CHECK(complaint([](D& d) { d.rule.resize(2, 3); }) ==
        "bodies: columns of the table of rules 3, expected as many as rows");
  CHECK(complaint([](D& d) { d.rule(0, 1) = d.rule(1, 0) = 1; }) ==
        "bodies: rule 1, expected a symmetric table of indices of rules, or no_rule");
  CHECK(complaint([](D& d) { d.rule(0, 1) = BodiesData::no_rule; }) ==
        "bodies: rule -1, expected a symmetric table of indices of rules, or no_rule");
}

TEST_CASE("The course of a load", "[system][bodies]") {
  CHECK(CourseData{}.constant());
  CHECK(CourseData{}.at(3) == 1);
  const CourseData points{{1, 2, 4}, {5, 3, -1}, 0, 0};
  CHECK(!points.constant());
  CHECK(points.at(0) == 5);
  CHECK(points.at(1.5) == 4);
  CHECK(points.at(2) == 3);
  CHECK(points.at(3.5) == 0);
  CHECK(points.at(9) == -1);
  const CourseData wave{{}, {}, 0.25, 0};
  CHECK(std::abs(wave.at(1)) <= 1e-16);
  CHECK(wave.at(2) == -1);
  CHECK(std::abs(CourseData{{0}, {2}, 0.5, 0.3}.at(2) - 2 * std::cos(0.3)) <= 1e-15);
}
