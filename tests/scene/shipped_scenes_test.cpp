// Every scene that ships is read, run and held against its stored reference (reference_data/scenes/).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "contensou/output/table.hpp"
#include "contensou/scene/outcome.hpp"
#include "contensou/scene/run.hpp"
#include "contensou/scene/scene.hpp"

using namespace contensou;

namespace {

const std::filesystem::path scenes = CONTENSOU_SCENES;
const std::filesystem::path references = CONTENSOU_REFERENCE_DATA "/scenes";

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

Scene scene(const std::string& name, const std::string& change = "-") {
  SceneDocument document = read_document(scenes / (name + ".toml"));
  if (change != "-") set_value(document, change);
  return read_scene(document);
}

/// All its outcomes, by name.
std::map<std::string, double> outcomes(const Scene& scene) {
  Simulation simulation = compose(scene);
  const Outcome outcome = run(simulation);
  CHECK(outcome.report.status == RunStatus::finished);
  std::map<std::string, double> values;
  for (const MeasureScene& measure : scene.measures) values[measure.name] = evaluate(measure, outcome);
  return values;
}

void check_against_reference(const std::string& name) {
  const Table table = read_table(references / (name + ".tsv"));
  const auto changes = table.texts("changes"), measured = table.texts("outcome");
  const auto expected = table.numbers("value"), allowed = table.numbers("allowed");
  std::map<std::string, std::map<std::string, double>> runs;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (!runs.contains(changes[i])) runs[changes[i]] = outcomes(scene(name, changes[i]));
    CAPTURE(name, changes[i], measured[i], expected[i], allowed[i]);
    REQUIRE(runs[changes[i]].contains(measured[i]));
    CHECK(std::abs(runs[changes[i]][measured[i]] - expected[i]) <= allowed[i]);
  }
}

}  // namespace

TEST_CASE("Shipped scenes: each has a reference, and a question at its top", "[scene][shipped]") {
  std::set<std::string> names, stored;
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) names.insert(entry.path().stem());
  for (const auto& entry : std::filesystem::directory_iterator(references))
    stored.insert(entry.path().stem());
  names.erase("tippe_top");  // reference_data/motions
  CHECK(names == stored);
  for (const std::string& name : names) {
    const std::string text = read_text(scenes / (name + ".toml"));
    CAPTURE(name);
    CHECK(text.starts_with("# "));
    CHECK(text.substr(0, text.find('\n')).ends_with('?'));
    CHECK(text.find("contensou simulate scenes/" + name + ".toml") != std::string::npos);
    CHECK_FALSE(scene(name).measures.empty());
  }
}

TEST_CASE("Shipped scenes: the tippe-top as a rigid body", "[scene][shipped]") {
  check_against_reference("tippe_top_bodies");
}
TEST_CASE("Shipped scenes: the sliding disc", "[scene][shipped]") { check_against_reference("sliding_disc"); }
TEST_CASE("Shipped scenes: the polishing machine", "[scene][shipped]") {
  check_against_reference("polishing_machine");
}
TEST_CASE("Shipped scenes: the ball with sidespin", "[scene][shipped]") {
  check_against_reference("sidespin");
}
TEST_CASE("Shipped scenes: the bouncing ball", "[scene][shipped]") {
  check_against_reference("bouncing_ball");
}
TEST_CASE("Shipped scenes: the free body", "[scene][shipped]") { check_against_reference("free_body"); }
TEST_CASE("Shipped scenes: the ball in a corner", "[scene][shipped]") { check_against_reference("corner"); }

TEST_CASE("Shipped scenes: the pile is one of many", "[scene][shipped]") {
  const Table table = read_table(references / "pile.tsv");
  const auto names = table.texts("outcome");
  const auto mean = table.numbers("mean"), deviation = table.numbers("deviation");
  const auto values = outcomes(scene("pile"));
  for (std::size_t i = 0; i < names.size(); ++i) {
    CAPTURE(names[i], mean[i], deviation[i]);
    if (names[i] != "kinetic") CHECK(std::abs(values.at(names[i]) - mean[i]) <= 6 * deviation[i]);
  }
}
