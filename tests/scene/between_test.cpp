#include "contensou/scene/between.hpp"

#include <catch2/catch.hpp>

#include "bodies_scene.hpp"

using namespace contensou;
using namespace contensou::test;

namespace {

/// The name of the contact between two surfaces; empty: there is none.
std::string rule(const BodiesScene& scene, std::size_t a, std::size_t b) {
  const int index = scene.data.rule(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
  CHECK(index == scene.data.rule(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(a)));
  return index == BodiesData::no_rule ? "" : scene.contacts[static_cast<std::size_t>(index)].name;
}

}  // namespace

TEST_CASE("Scene of bodies: names stand for surfaces", "[scene]") {
  const Scene scene = changed({});
  const BodiesScene& bodies = bodies_of(scene);
  const BodiesData& data = bodies.data;
  const std::size_t tip = data.bodies[0].spheres[0].surface, hull = data.bodies[0].spheres[1].surface,
                    base = data.bodies[1].base->surface, rim = data.bodies[2].spheres[0].surface,
                    bead = data.bodies[3].spheres[0].surface, pile = data.bodies[4].spheres[0].surface,
                    floor = data.planes[0].surface, west = data.planes[2].surface;
  CHECK(data.rule.rows() == 11);
  CHECK(data.bodies[8].spheres[0].surface == pile);
  CHECK(rule(bodies, tip, floor) == "top");
  CHECK(rule(bodies, hull, floor) == "");
  CHECK(rule(bodies, base, floor) == "slide");
  CHECK(rule(bodies, pile, pile) == "pile");
  CHECK(rule(bodies, pile, west) == "walls");
  CHECK(rule(bodies, pile, data.planes[4].surface) == "walls");
  CHECK(rule(bodies, pile, floor) == "");
  CHECK(rule(bodies, tip, rim) == "hulls");
  CHECK(rule(bodies, hull, rim) == "hulls");
  CHECK(rule(bodies, bead, rim) == "");
  CHECK(rule(bodies, tip, hull) == "");
}

TEST_CASE("Scene of bodies: pairs are counted and named as the system does", "[scene]") {
  const Scene scene = changed({});
  // By hand: top 1, slide 1, five balls in pairs 10, on three sides 15, two spheres at the brush 2.
  CHECK(count_pairs(bodies_of(scene).data, 5) == std::vector<std::size_t>{1, 1, 10, 15, 2});
  const std::vector<PairName> names = pair_names(bodies_of(scene));
  REQUIRE(names.size() == 29);
  CHECK((names[0].name == "top" && names[1].name == "slide"));
  CHECK((names[2].name == "pile_1" && names[11].name == "pile_10" && names[12].name == "walls_1"));
  CHECK((names[28].name == "hulls_2" && names[28].rule == 4));
}

TEST_CASE("Scene of bodies: contacts that cannot be are refused", "[scene]") {
  const std::vector<Refused> cases{
      {{{}, {"contact.top.between=['top.tip','flor']"}},
       {"--set contact.top.between: ['top.tip','flor'] names \"flor\"",
        "top, puck, brush, bead, pile, floor"}},
      {{{}, {"contact.top.between=['top.nose','floor']"}}, {"names \"top.nose\""}},
      {{{}, {"contact.top.between=['pile.1','floor']"}}, {"names \"pile.1\""}},
      {{{}, {"contact.top.between=['top.tip']"}}, {"1 entry", "two names"}},
      {{{}, {"contact.top.between='floor'"}}, {"is not an array of strings"}},
      {{{}, {"contact.top.between=['a','b','c']"}}, {"3 entries"}},
      {{{}, {"contact.top.between=[1,2]"}}, {"is not an array of strings"}},
      {{{}, {"contact.top.between=['top','top']"}}, {"names nothing that can touch"}},
      {{{}, {"contact.top.between=['floor','hall']"}}, {"names nothing that can touch"}},
      {{{}, {"contact.slide.between=['top','floor']"}},
       {"contact.slide.between", "top.tip and floor", "contact top", "one contact for each pair"}},
      {{{}, {"contact.pile.between=['pile','hall.west']"}},
       {"f.toml:", "contact.walls.between", "pile and hall.west", "contact pile"}},
      {{{}, {"contact.slide.between=['puck','slope']"}}, {"puck.base and slope", "not across the axis"}},
      {{{}, {"contact.slide.between=['puck','hall']"}}, {"puck.base and hall.west", "not across the axis"}},
      {{{}, {"contact.slide.between=['pile','puck']"}}, {"puck.base and pile", "planes only"}},
      {{{}, {"contact.hulls.between=['bead','slope']"}}, {"bead.all and slope", "nothing can turn"}},
      {{{},
        {"contact.hulls.radius='hertz'", "contact.hulls.modulus=1e9",
         "contact.hulls.between=['puck','floor']", "integrator.method=moreau", "integrator.step=1e-3",
         "contact.slide.between=['bead','slope']"}},
       {"puck.base and floor", "no radius by Hertz"}},
      {{{}, {"contact.pile_1={law='frictionless', between=['bead','slope']}"}},
       {"[contact.pile", "a second contact named pile_1"}},
      {{{}, {"balls.pile.count=13"}}, {"integrator.method", "watch all of 121 pairs", "at most 100", "nscd"}},
  };
  for (const Refused& refused : cases) CHECK(check_refused(refused) == "");
  // 12 balls: 66 pairs and 36 at walls, 3 of others, 1 + 1 + 2: 106.
  CHECK(!refusal({{}, {"balls.pile.count=12"}}).empty());
  CHECK(refusal({{"output.columns", "outcome"}, {"balls.pile.count=11"}}).empty());  // 55 + 33 + 4
  CHECK(refusal({{"output.columns", "outcome"},
                 {"balls.pile.count=1000", "integrator.method=nscd", "integrator.step=1e-3"}})
            .empty());
  // One ball has nothing to touch among balls, and that is no error: counts are varied.
  CHECK(refusal({{"output.columns", "outcome"}, {"balls.pile.count=1"}}).empty());
}
