#include "contensou/scene/reader.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "refusal.hpp"

using namespace contensou;
using contensou::test::refusal_of;

namespace {

SceneDocument document() {
  return parse_document(
      "[b.two]\nx = 1\nv = [1, 2, 3]\nwords = [\"p\", \"q\"]\n[b.one]\nx = 2\n[b.one.deeper]\n[b.\"q.r\"]\ny "
      "= 1\n"
      "[empty]\n",
      "f.toml");
}

}  // namespace

TEST_CASE("Scene reader: tables in the order of the file", "[scene]") {
  SceneDocument scene = document();
  SceneReader read(scene);
  CHECK(read.tables("b") == std::vector<std::string>{"two", "one"});
  CHECK(read.tables("b.one") == std::vector<std::string>{"deeper"});
  CHECK(read.tables("b.two").empty());
  CHECK(read.tables("nosuch").empty());
  CHECK(read.has_table("empty"));
  CHECK(!read.has_table("b.three"));
  set_value(scene, "b.three={x=3}");
  CHECK(SceneReader(scene).tables("b") == std::vector<std::string>{"three", "two", "one"});
}

TEST_CASE("Scene reader: arrays, and what stands in where they are missing", "[scene]") {
  const SceneDocument scene = document();
  SceneReader read(scene);
  CHECK(read.vector("b.two.v") == Eigen::Vector3d(1, 2, 3));
  CHECK(read.numbers("b.two.v", {}).size() == 3);
  CHECK(read.texts("b.two.words", {}) == std::vector<std::string>{"p", "q"});
  CHECK(read.whole("b.one.x", 0, 5) == 2);
  CHECK(read.is_array("b.two.v"));
  CHECK(!read.is_array("b.two.words"));
  CHECK(!read.optional_vector("b.one.v"));
  CHECK(!read.optional_whole("b.one.n", 0, 1));
  CHECK(std::isnan(read.vector("b.one.w")[1]));
  CHECK(read.numbers("b.one.m", {}).empty());
  CHECK(read.texts("b.one.t", {}).empty());
  CHECK(read.whole("b.one.k", 3, 5) == 3);
}

TEST_CASE("Scene reader: unknown keys come first, then the first that is missing, with its table",
          "[scene]") {
  const SceneDocument scene = document();
  SceneReader read(scene);
  CHECK(read.tables("b").size() == 2);
  read.number("b.one.mass", positive);
  read.number("b.two.x", positive);
  CHECK(refusal_of([&] {
          read.finish();
        }).starts_with("f.toml:3: b.two.v: unknown key, value [1, 2, 3]; expected one of x"));
  CHECK(refusal_of([&] { read.refuse_table("b.one", "is odd", "another"); }) ==
        "f.toml:5: [b.one] is odd; expected another");
  CHECK(refusal_of([&] { read.refuse_table("c", "is odd", "another"); }) ==
        "f.toml: [c] is odd; expected another");
  CHECK(refusal_of([&] { read.refuse_scene("nothing", "more"); }) == "f.toml: nothing; expected more");

  const SceneDocument small = parse_document("[a]\nx = 1\n", "f.toml");
  SceneReader other(small);
  other.number("a.x", positive);
  other.vector("a.v");
  other.number("c.y", positive);
  CHECK(refusal_of([&] { other.finish(); }) ==
        "f.toml:1: a.v is missing; expected an array of three finite numbers");
}
