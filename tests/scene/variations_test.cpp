#include "contensou/scene/variations.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace contensou;

namespace {

SceneDocument top(std::initializer_list<std::string_view> sets = {}) {
  SceneDocument document = read_document(CONTENSOU_SCENES "/tippe_top.toml");
  for (const std::string_view assignment : sets) set_value(document, assignment);
  return document;
}

std::vector<Variation> of(const SceneDocument& document) {
  return variations(document, read_scene(document));
}

const Variation* find(const std::vector<Variation>& all, std::string_view effect, std::string_view variant,
                      std::string_view contacts = "") {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Variation& v) {
    return v.effect == effect && v.variant == variant && v.contacts == contacts;
  });
  return found == all.end() ? nullptr : &*found;
}

Scene read(const SceneDocument& document, std::string_view effect, std::string_view variant,
           std::string_view contacts = "") {
  const std::vector<Variation> all = of(document);
  const Variation* variation = find(all, effect, variant, contacts);
  REQUIRE(variation != nullptr);
  return read_variation(*variation, read_scene(document));
}

}  // namespace

TEST_CASE("Variations: the scene itself comes first, all read, none twice", "[scene][variations]") {
  for (const SceneDocument& document :
       {top(), top({"integrator.method=moreau", "contact.tip.restitution=0.5"}),
        top({"contact.body={law=\"coulomb\", mu=0.2}", "scene.gravity=0"}),
        top({"contact.tip={law=\"frictionless\"}", "contact.body.model=ellipsoid",
             "integrator.method=rk4_printed", "integrator.r=1e-3"})}) {
    const std::vector<Variation> all = of(document);
    CHECK(all[0].options.empty());
    const Scene scene = read_scene(document);
    for (std::size_t i = 0; i < all.size(); ++i) {
      CAPTURE(all[i].effect, all[i].variant, all[i].contacts);
      CHECK_NOTHROW(read_variation(all[i], scene));
      CHECK(all[i].against <= i);
      if (i > 0) CHECK_FALSE(all[i].options.empty());
      for (std::size_t k = 0; k < i; ++k) CHECK(all[i].options != all[k].options);
    }
  }
}

TEST_CASE("Variations: the options of one make its document", "[scene][variations]") {
  SceneDocument document = top({"contact.tip.restitution=0.5"});
  const std::vector<Variation> all = of(document);
  unset_value(document, "outcome");  // read_variation() takes them from the scene
  for (const Variation& variation : all) {
    SceneDocument same = document;
    for (const std::string& option : variation.options) {
      const std::string what = option.substr(option.find(' ') + 1);
      option.starts_with("--set ") ? set_value(same, what) : unset_value(same, what);
    }
    CAPTURE(variation.effect, variation.variant);
    REQUIRE(same.values.size() == variation.document.values.size());
    for (const auto& [key, value] : same.values) {
      REQUIRE(variation.document.values.contains(key));
      CHECK(value.value == variation.document.values.at(key).value);
    }
  }
}

TEST_CASE("Variations: friction becomes simpler, at all contacts and at each", "[scene][variations]") {
  for (const char* contacts : {"body, tip", "body", "tip"}) {
    const auto rows = [&](const char* variant) {
      const Scene scene = read(top(), "friction", variant, contacts);
      return std::pair{scene.contacts()[0]->rows(), scene.contacts()[1]->rows()};
    };
    const bool body = std::string_view(contacts) != "tip", tip = std::string_view(contacts) != "body";
    CHECK(rows("ellipsoid") == std::pair{4, 4});
    CHECK(rows("uncoupled") == std::pair{4, 4});
    CHECK(rows("coulomb") == std::pair{body ? 3 : 4, tip ? 3 : 4});
    CHECK(rows("frictionless") == std::pair{body ? 1 : 4, tip ? 1 : 4});
  }
  const Scene ellipsoid = read(top(), "friction", "ellipsoid", "tip");
  CHECK(ellipsoid.contacts()[0]->model == "exact");
  CHECK(ellipsoid.contacts()[1]->model == "ellipsoid");
  CHECK(read(top(), "pressure", "uniform", "body, tip").contacts()[1]->pressure == "uniform");
}

TEST_CASE("Variations: only what is there is switched off", "[scene][variations]") {
  const std::vector<Variation> all = of(top({"contact.tip={law=\"coulomb\", mu=0.1}"}));
  CHECK(find(all, "friction", "exact", "body") == nullptr);
  CHECK(find(all, "friction", "coulomb", "body") != nullptr);
  CHECK(find(all, "friction", "coulomb", "tip") == nullptr);
  CHECK(find(all, "friction", "frictionless", "body, tip") != nullptr);
  CHECK(find(all, "pressure", "hertz", "body") == nullptr);
  CHECK(find(all, "restitution", "off", "body") == nullptr);
  CHECK(find(all, "drag", "off") == nullptr);
  CHECK(find(all, "loads", "off") == nullptr);
  CHECK(find(all, "gravity", "off") != nullptr);
  CHECK(find(of(top({"scene.gravity=0"})), "gravity", "off") == nullptr);
  CHECK(read(top({"contact.tip.restitution=0.5"}), "restitution", "off", "tip").contacts()[1]->restitution ==
        0);
}

TEST_CASE("Variations: uncoupled friction is compared where it can be run", "[scene][variations]") {
  const std::vector<Variation> located = of(top());
  const Variation* uncoupled = find(located, "friction", "uncoupled", "body, tip");
  REQUIRE(uncoupled != nullptr);
  CHECK(located[uncoupled->against].effect == "method");
  CHECK(located[uncoupled->against].variant == "moreau");
  CHECK(read_scene(uncoupled->document).integrator.method == Method::moreau);
  CHECK(find(located, "friction", "ellipsoid", "body, tip")->against == 0);

  const std::vector<Variation> stepped = of(top({"integrator.method=moreau"}));
  CHECK(find(stepped, "friction", "uncoupled", "body, tip")->against == 0);
  CHECK(find(stepped, "method", "event_driven") != nullptr);
}

TEST_CASE("Variations: outcomes are those of the scene", "[scene][variations]") {
  for (const char* variant : {"coulomb", "frictionless"}) {
    const Scene scene = read(top(), "friction", variant, "body, tip");
    REQUIRE(scene.measures.size() == read_scene(top()).measures.size());
    CHECK(scene.measures[0].name == read_scene(top()).measures[0].name);
  }
}

TEST_CASE("Variations: steps and tolerances become coarser", "[scene][variations]") {
  CHECK(read(top(), "integrator", "100 times the tolerance").integrator.tolerance == Approx(1e-8));
  const SceneDocument moreau = top({"integrator.method=moreau"});
  CHECK(read(moreau, "integrator", "2 times the step").integrator.step == 2e-4);
  CHECK(read(moreau, "integrator", "10 times the step").integrator.step == 1e-3);
  // A scene without a step of its own gets a ten thousandth of the duration.
  SceneDocument without = top();
  unset_value(without, "integrator.step");
  CHECK(read(without, "method", "moreau").integrator.step == Approx(8e-4));
}
