#include "contensou/scene/start.hpp"

#include <catch2/catch.hpp>

#include "bodies_scene.hpp"

using namespace contensou;
using namespace contensou::test;

namespace {

/// Two kinds of balls and a body among them, everything touching everything.
constexpr std::string_view mixture = R"([scene]
system = "bodies"
duration = 1
[balls.large]
count = 125
radius = 0.5
mass = 1
lower = [0, 0, 0]
spacing = 2
across = [5, 5]
rotation = "none"
[balls.small]
count = 64
radius = 0.25
mass = 1
lower = [1, 1, 1]
spacing = 2
across = [4, 4]
rotation = "none"
[body.giant]
rotation = "none"
mass = 1
position = [-3, 4, 4]
[body.giant.sphere.all]
radius = 2
[plane.slope]
normal = [0.6, 0, 0.8]
offset = -10
[contact.balls]
law = "frictionless"
between = ["large", "small"]
[contact.large]
law = "frictionless"
between = ["large", "giant"]
[contact.small]
law = "frictionless"
between = ["slope", "small"]
[integrator]
method = "nscd"
step = 1e-3
)";

std::string refused(std::vector<std::string> sets) { return refusal({{}, std::move(sets)}, mixture); }

}  // namespace

TEST_CASE("Start: what is apart may start, what just touches, too", "[scene]") {
  CHECK(refused({}) == "");
  CHECK(refused({"body.giant.position=[-2.5,4,4]"}) == "");  // touches large.61 at x = 0
  CHECK(refused({"balls.small.lower=[0.75,0,0]"}) == "");
  CHECK(refused({"plane.slope.offset=1.15"}) == "");  // 0.6 + 0.8 - 0.25: touches the corner
}

TEST_CASE("Start: what is in something else is named with how deep", "[scene]") {
  const std::vector<Refused> cases{
      {{{}, {"body.giant.position=[-2.25,4,4]"}},
       {"--set body.giant.position: [-2.25,4,4] puts giant.all 0.25 m deep into large."}},
      {{{}, {"balls.small.lower=[0.5,0,0]"}},
       {"balls.large.lower: [0, 0, 0] puts large.1 0.25 m deep into small.1"}},
      {{{}, {"plane.slope.offset=2"}}, {"balls.small.lower", "puts small.", "m deep into slope"}},
      {{{}, {"body.giant.position=[4,4,4]"}}, {"puts giant.all", "deep into large."}},
      {{{}, {"body.giant.position=[-3,4,1e308]", "body.giant.sphere.all.centre=[0,0,1e308]"}},
       {"beyond numbers"}},
  };
  for (const Refused& r : cases) CHECK(check_refused(r, mixture) == "");
}

TEST_CASE("Start: a single deep pair among many is found wherever it is", "[scene]") {
  // The lattice of small balls is moved so that just its last layer meets the large ones: compare with all
  // pairs.
  for (const char* lower : {"[0.6,0.1,7.6]", "[-5.4,-5.6,-5.5]", "[7.7,7.6,7.7]", "[7.75,7.7,7.8]"}) {
    const std::string set = "balls.small.lower=" + std::string(lower);
    const Scene scene = changed({{"contact.balls"}, {set}}, mixture);
    const std::vector<BodyData>& bodies = bodies_of(scene).data.bodies;
    bool apart = true;
    for (const BodyData& a : bodies) {
      for (const BodyData& b : bodies) {
        if (!a.name.starts_with("large") || !b.name.starts_with("small")) continue;
        apart = apart && (a.position - b.position).norm() >= 0.75;
      }
    }
    INFO(set);
    CHECK(refused({set}).empty() == apart);
  }
}

TEST_CASE("Start: two hundred thousand balls are looked at in a moment, not pair by pair", "[scene]") {
  const Scene scene =
      changed({{},
               {"balls.large.count=100000", "balls.large.across=[80,80]", "balls.small.count=100000",
                "balls.small.across=[80,80]", "body.giant.position=[-30,4,4]", "plane.slope.offset=-1000"}},
              mixture);
  CHECK(bodies_of(scene).data.bodies.size() == 200001);
}
