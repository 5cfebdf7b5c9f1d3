#include "contensou/system/body_contacts.hpp"

#include <catch2/catch.hpp>

#include "bodies_examples.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

/// Two balls (surface 0) and a disc (1) over a floor (2) and beside a wall (3).
BodiesData room() {
  BodiesData data;
  BodyData disc = ball("disc", 1, 1, 0);
  disc.rotation = Rotation::upright;
  disc.spheres.clear();
  disc.base = BaseData{"disc.base", 0.2, 1};
  data.bodies = {ball("a", 1, 0.2, 0), ball("b", 1, 0.3, 0), disc};
  data.planes = {floor_plane(2), {"wall", Vector3d::UnitX(), -1, 3}};
  data.rules = {named(hertz_floor(), "balls"), named(coulomb_floor(), "planes"),
                named(uniform_floor(), "lying")};
  set_rules(data, 4, {{0, 0}, {0, 2}, {1, 2}});
  data.rule(0, 3) = data.rule(3, 0) = 1;
  return data;
}

}  // namespace

TEST_CASE("Pairs: each with a rule once, in order, with names", "[system][bodies]") {
  const BodiesData data = room();
  const std::vector<BodyPair> pairs = body_pairs(data);
  const std::vector<SystemContact> contacts = pair_contacts(data, pairs);
  std::vector<std::string> names;
  for (const SystemContact& contact : contacts) names.push_back(contact.name);
  CHECK(names == std::vector<std::string>{"balls", "planes_1", "planes_2", "planes_3", "planes_4", "lying"});
  REQUIRE(pairs.size() == 6);
  CHECK(pairs[0].side.body == 1);
  REQUIRE(pairs[0].other);
  CHECK(pairs[0].other->body == 0);
  CHECK(pairs[2].side.body == 0);
  CHECK(pairs[2].plane == 1);
  CHECK(!pairs[5].side.sphere);
  CHECK(pairs[5].side.reach == 0.2);
  CHECK(pairs[5].side.lever == 0);
}

TEST_CASE("Pairs: the relative radius is the pair's own", "[system][bodies]") {
  BodiesData data = room();
  data.rules[0].load_radius = LoadRadius{99, 1e9};
  CHECK(pair_contacts(data, body_pairs(data))[0].load_radius->relative_radius == Approx(0.12).epsilon(1e-15));
  data.rules[1] = data.rules[0];
  CHECK(pair_contacts(data, body_pairs(data))[3].load_radius->relative_radius == 0.3);
  data.rules[2].load_radius = LoadRadius{99, 1e9};
  CHECK_THROWS_WITH(
      pair_contacts(data, body_pairs(data)),
      "disc.base touches plane floor by rule lying, expected a contact radius that does not follow the load");
}

TEST_CASE("Pairs that a rule cannot be of", "[system][bodies]") {
  BodiesData data = room();
  data.rule(1, 3) = data.rule(3, 1) = 2;
  CHECK_THROWS_WITH(
      body_pairs(data),
      "disc.base touches plane wall by rule lying, expected a plane across the third axis of the body");
  data = room();
  data.rule(1, 0) = data.rule(0, 1) = 0;
  CHECK_THROWS_WITH(body_pairs(data),
                    "disc.base touches a.shell by rule balls, expected a base to touch planes only");
  data = room();
  data.bodies[0].rotation = data.bodies[1].rotation = Rotation::none;
  CHECK_THROWS_WITH(
      body_pairs(data),
      "b.shell touches a.shell by rule balls, expected friction without drilling where no body can spin");
}
