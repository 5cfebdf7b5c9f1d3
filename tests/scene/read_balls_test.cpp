#include "contensou/scene/read_balls.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "bodies_scene.hpp"

using namespace contensou;
using namespace contensou::test;
using Eigen::Vector3d;

TEST_CASE("Balls: homogeneous, all alike, on their lattice", "[scene]") {
  const Scene scene = changed({{"balls.pile.jitter", "balls.pile.seed"}, {"balls.pile.across=[2,2]"}});
  const std::vector<BodyData>& bodies = bodies_of(scene).data.bodies;
  REQUIRE(bodies.size() == 9);
  for (std::size_t i = 4; i < 9; ++i) {
    const BodyData& ball = bodies[i];
    CHECK(ball.name == "pile." + std::to_string(i - 3));
    CHECK(ball.rotation == Rotation::free);
    CHECK(ball.mass == 2);
    // 2/5 2 kg (1/4 m)²
    CHECK(ball.inertia.isApprox(Vector3d::Constant(0.05), 1e-15));
    CHECK((ball.velocity == Vector3d(0, 0, -1) && ball.spin == Vector3d(0, 1, 0)));
    CHECK((ball.drag.linear == 0.125 && ball.drag.angular == 0.0625));
    REQUIRE(ball.spheres.size() == 1);
    CHECK((ball.spheres[0].radius == 0.25 && ball.spheres[0].centre.isZero(0)));
    CHECK(ball.spheres[0].name == ball.name);
  }
  CHECK(bodies[4].position == Vector3d(20, 0, 1));
  CHECK(bodies[5].position == Vector3d(21, 0, 1));
  CHECK(bodies[6].position == Vector3d(20, 1, 1));
  CHECK(bodies[7].position == Vector3d(21, 1, 1));
  CHECK(bodies[8].position == Vector3d(20, 0, 2));
}

TEST_CASE("Balls: jitter is bounded, and the same on every platform", "[scene]") {
  const auto start = [](const char* seed) {
    const Scene scene =
        changed({{"outcome", "output.columns"}, {seed, "balls.pile.count=11", "balls.pile.across=[11,1]"}});
    std::vector<Vector3d> offsets;
    const std::vector<BodyData>& bodies = bodies_of(scene).data.bodies;
    for (std::size_t i = 4; i < bodies.size(); ++i)
      offsets.push_back(bodies[i].position - Vector3d(20 + static_cast<double>(i - 4), 0, 1));
    return offsets;
  };
  const std::vector<Vector3d> seven = start("balls.pile.seed=7");
  for (const Vector3d& offset : seven) CHECK(offset.lpNorm<Eigen::Infinity>() <= 0.25);
  CHECK(seven == start("balls.pile.seed=7"));
  CHECK(seven != start("balls.pile.seed=8"));
  // The generator is the standard's: its 10000th number from the default seed is given there.
  std::mt19937_64 standard;
  standard.discard(9999);
  CHECK(standard() == 9981545732273789042ULL);
  // And the first ball's offset is made of its first number by integer arithmetic and exact steps.
  std::mt19937_64 random(7);
  const double x = static_cast<double>(random() >> 11) / 9007199254740992.0;
  CHECK(seven[0][0] == (20 + 0.25 * (2 * x - 1)) - 20);
}

TEST_CASE("Balls: what makes no sense is refused", "[scene]") {
  const std::vector<Refused> cases{
      {{{}, {"balls.pile.count=0"}}, {"balls.pile.count: 0", "from 1 to 1000000"}},
      {{{}, {"balls.pile.count=1e7"}}, {"balls.pile.count: 1e7", "1000000"}},
      {{{}, {"balls.pile.count=1e308"}}, {"balls.pile.count"}},
      {{{}, {"balls.pile.count=2.5"}}, {"2.5 is not whole"}},
      {{{}, {"balls.pile.radius=0"}}, {"balls.pile.radius: 0"}},
      {{{}, {"balls.pile.radius=1e-200"}}, {"balls.pile.radius", "moment of inertia"}},
      {{{}, {"balls.pile.mass=-2"}}, {"balls.pile.mass: -2"}},
      {{{}, {"balls.pile.spacing=0.49"}}, {"balls.pile.spacing: 0.49 lets balls overlap"}},
      {{{}, {"balls.pile.spacing=1e308", "balls.pile.across=[1,1]"}}, {"larger than numbers"}},
      {{{}, {"balls.pile.across=[2]"}}, {"1 entry", "two whole numbers"}},
      {{{}, {"balls.pile.across=[2,0]"}}, {"holds 0"}},
      {{{}, {"balls.pile.across=[2,1.5]"}}, {"is not whole"}},
      {{{}, {"balls.pile.across=[1e5,1e5]"}}, {"more than 1e6"}},
      {{{}, {"balls.pile.jitter=0.26"}}, {"balls.pile.jitter: 0.26", "spacing/2 - radius"}},
      {{{}, {"balls.pile.seed=-1"}}, {"balls.pile.seed: -1"}},
      {{{"balls.pile.jitter"}, {}}, {"balls.pile.seed: 7 is not used by balls without jitter"}},
      {{{}, {"balls.pile.rotation=upright"}}, {"\"upright\" is unknown", "\"free\" \"none\""}},
      {{{}, {"balls.pile.rotation=none"}}, {"angular_drag: 0.0625 is not used by rotation none"}},
      {{{},
        {"balls.more={count=1000000, radius=1, mass=1, lower=[0,0,0], spacing=2, across=[9,9], "
         "rotation='none'}"}},
       {"count", "more than 1e6 balls in all"}},
  };
  for (const Refused& refused : cases) CHECK(check_refused(refused) == "");
  // 0.03/2 - 0.01 is less than 0.005 by rounding.
  CHECK(refusal({{}, {"balls.pile.radius=0.01", "balls.pile.spacing=0.03", "balls.pile.jitter=0.005"}})
            .empty());
}
