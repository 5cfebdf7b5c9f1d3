#include "contensou/scene/grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "contensou/scene/scene.hpp"
#include "contensou/text/name.hpp"

#include "refusal.hpp"

using namespace contensou;

namespace {

using Values = std::vector<std::string>;

std::vector<double> numbers(const GridAxis& variation) {
  std::vector<double> numbers;
  for (const std::string& value : variation.values) REQUIRE(parse(value, numbers.emplace_back()));
  return numbers;
}

/// What is said of a variation that is none.
std::string refusal(std::string_view text) {
  return contensou::test::refusal_of([&] { parse_axis(text); });
}

}  // namespace

TEST_CASE("Grid: evenly spaced numbers, ends included, round ones exact", "[scene]") {
  const GridAxis spin = parse_axis("initial.psi_dot=60:250:20");
  CHECK(spin.key == "initial.psi_dot");
  CHECK(spin.values == Values{"60",  "70",  "80",  "90",  "100", "110", "120", "130", "140", "150",
                              "160", "170", "180", "190", "200", "210", "220", "230", "240", "250"});
  CHECK(parse_axis("a=0:1:11").values ==
        Values{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"});
  CHECK(parse_axis("a=2:-2:5").values == Values{"2", "1", "0", "-1", "-2"});
  CHECK(parse_axis("a=0.1:0.3:3").values == Values{"0.1", "0.2", "0.3"});
  CHECK(parse_axis("a=1e-3:3e-3:2").values == Values{"0.001", "0.003"});
  CHECK(parse_axis("a=5:5:3").values == Values{"5", "5", "5"});
}

TEST_CASE("Grid: even ratios, ends included, powers of ten exact", "[scene]") {
  CHECK(parse_axis("r=1e-6:1e-3:4:log").values == Values{"1e-06", "1e-05", "1e-04", "0.001"});
  CHECK(parse_axis("r=-1000:-0.1:5:log").values == Values{"-1000", "-100", "-10", "-1", "-0.1"});
  const std::vector<double> radius = numbers(parse_axis("r=1e-6:3e-3:40:log"));
  REQUIRE(radius.size() == 40);
  CHECK(radius.front() == 1e-6);
  CHECK(radius.back() == 3e-3);
  // Each rounded once to a double; before that, an exponent of magnitude 6 in 64 bits: 6 * 2^-64 ln 10 more.
  const double ratio = std::pow(3000.0, 1.0 / 39);  // and this once, and an exponent
  for (std::size_t i = 1; i < radius.size(); ++i)
    CHECK(radius[i] / radius[i - 1] == Approx(ratio).epsilon(6 * 1.2e-16));
}

TEST_CASE("Grid: lists of words, numbers, arrays, strings", "[scene]") {
  CHECK(parse_axis("integrator.method=moreau,rk4").values == Values{"moreau", "rk4"});
  CHECK(parse_axis("a=1,10,3.5").values == Values{"1", "10", "3.5"});
  CHECK(parse_axis("a=[1,0,0],[0,1,0]").values == Values{"[1,0,0]", "[0,1,0]"});
  CHECK(parse_axis("a={x=1,y=2},{x=3}").values == Values{"{x=1,y=2}", "{x=3}"});
  CHECK(parse_axis(R"(a="x,y",'z,"',"\",")").values == Values{R"("x,y")", R"('z,"')", R"("\",")"});
  CHECK(parse_axis("a=uniform").values == Values{"uniform"});
  CHECK(parse_axis("pressure=power:1").values == Values{"power:1"});
  CHECK(parse_axis("pressure=hertz,power:1,power:2").values == Values{"hertz", "power:1", "power:2"});
  CHECK(parse_axis("a=\"x:y:z\"").values == Values{"\"x:y:z\""});
}

TEST_CASE("Grid: what is no variation is refused with the key and what was expected", "[scene]") {
  for (const char* text : {"", "a", "=1", "=", "=1:2:3"})
    CHECK_THAT(refusal(text), Catch::StartsWith("--vary: ") && Catch::Contains("expected KEY=A:B:N"));
  for (const char* text :
       {"k=",          "k=1,",          "k=,1",        "k=1,,2",        "k= ",
        "k=1:2",       "k=1:2:3:log:5", "k=a:b:3",     "k=1::3",        "k=:1:3",
        "k=nan:1:3",   "k=1:inf:3",     "k=1e400:2:3", "k=1:2:1",       "k=1:2:0",
        "k=1:2:-3",    "k=1:2:2.5",     "k=1:2:",      "k=1:2:1000001", "k=1:2:99999999999999999999",
        "k=1:2:3:lin", "k=0:1:3:log",   "k=1:0:3:log", "k=-1:1:3:log",  "k=1,2,1"}) {
    CHECK_THAT(refusal(text), Catch::StartsWith("--vary k: ") && Catch::Contains("expected"));
    CHECK(refusal(text).find('\n') == std::string::npos);
  }
}

TEST_CASE("Grid: the last key varies fastest, and each combination comes once", "[scene]") {
  const Grid grid = make_grid({parse_axis("a=1,2"), parse_axis("b=x,y,z"), parse_axis("c=0:1:2")});
  REQUIRE(grid.size() == 12);
  CHECK(grid.values(0) == Values{"1", "x", "0"});
  CHECK(grid.values(1) == Values{"1", "x", "1"});
  CHECK(grid.values(2) == Values{"1", "y", "0"});
  CHECK(grid.values(11) == Values{"2", "z", "1"});
  std::set<Values> seen;
  for (std::size_t run = 0; run < grid.size(); ++run) seen.insert(grid.values(run));
  CHECK(seen.size() == 12);
  CHECK(describe(grid, 7) == "run 7 (a=2, b=x, c=1)");
  CHECK(make_grid({}).size() == 1);
  CHECK(describe(Grid{}, 0) == "run 0");
}

TEST_CASE("Grid: keys that undo each other, grids too large", "[scene]") {
  const GridAxis mu = parse_axis("contact.body.mu=0.1,0.3"), long_one = parse_axis("x=0:1:1000000");
  CHECK_THROWS_WITH(make_grid({mu, mu}),
                    Catch::StartsWith("--vary contact.body.mu: ") && Catch::Contains("twice"));
  const GridAxis body = parse_axis("contact.body={law=\"frictionless\"}");
  CHECK_THROWS_WITH(make_grid({mu, body}), Catch::Contains("undo each other"));
  CHECK_THROWS_WITH(make_grid({body, mu}), Catch::Contains("undo each other"));
  CHECK_NOTHROW(make_grid({mu, parse_axis("contact.body.mux=1,2")}));
  CHECK(make_grid({long_one}).size() == most_runs);
  CHECK_THROWS_WITH(make_grid({long_one, mu}), Catch::Contains("1000000 runs"));
}

TEST_CASE("Grid: a run's document holds its values", "[scene]") {
  const SceneDocument scene = read_document(CONTENSOU_SCENES "/tippe_top.toml");
  const Grid grid = make_grid(
      {parse_axis("contact.body.radius=1e-6:1e-3:4:log"), parse_axis("integrator.method=moreau,rk4")});
  const Scene run = read_scene(at(grid, 5, scene));
  CHECK(std::get<TippeTopScene>(run.system).contacts[0].radius == 1e-4);
  CHECK(run.integrator.method == Method::rk4);
  CHECK_THROWS_AS(at(make_grid({parse_axis("a b=1")}), 0, scene), SceneError);
}
