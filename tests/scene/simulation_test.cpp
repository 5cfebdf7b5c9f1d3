#include "contensou/scene/simulation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <type_traits>

#include "bodies_scene.hpp"
#include "contensou/scene/between.hpp"
#include "contensou/scene/effects.hpp"
#include "contensou/scene/run.hpp"
#include "contensou/system/rigid_bodies.hpp"
#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"

using namespace contensou;

namespace {

const TippeTopScene& top_of(const Scene& scene) { return std::get<TippeTopScene>(scene.system); }

Scene changed(std::initializer_list<std::string_view> sets) {
  SceneDocument scene = read_document(CONTENSOU_SCENES "/tippe_top.toml");
  for (const std::string_view assignment : sets) set_value(scene, assignment);
  return read_scene(scene);
}

template <class Law>
bool is_ball(const AnyFriction& friction) {
  return std::holds_alternative<FrictionBall<SmoothPlate<Law>>>(friction);
}

/// What the first row of the trajectory tells in a column.
double told(const Simulation& simulation, std::string_view column) {
  std::vector<double> row;
  const std::vector<ContactMode> modes(2, ContactMode::open);
  simulation.describe({simulation.state.t, simulation.state.q, simulation.state.u, modes}, row);
  REQUIRE(row.size() == simulation.columns.size());
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (simulation.columns[i] == column) return row[i];
  }
  FAIL("no column " << column);
  return 0;
}

}  // namespace

TEST_CASE("Simulation: a contact has the rows that its law asks for", "[scene]") {
  ContactScene contact;
  contact.pressure = "hertz";
  contact.model = "exact";
  contact.radius = 1e-3;
  CHECK(rows(make_friction(contact)) == 1);
  contact.law = ContactLaw::coulomb;
  CHECK(rows(make_friction(contact)) == 3);
  contact.law = ContactLaw::contensou;
  CHECK(rows(make_friction(contact)) == 4);
  CHECK(is_ball<HertzLaw>(make_friction(contact)));
  contact.pressure = "uniform";
  CHECK(is_ball<UniformLaw>(make_friction(contact)));
  contact.pressure = "power:2";
  CHECK(is_ball<CompiledLaw>(make_friction(contact)));
  contact.radius = 0;
  CHECK(std::holds_alternative<FrictionDisk>(make_friction(contact)));
}

TEST_CASE("Simulation: the ellipsoid has the semi-axes of the pressure's ball", "[scene]") {
  // 2/3 uniform, 3 pi/16 Hertz, 8/15 paraboloid: the torque of pure spinning in units of mu lambda_N R.
  ContactScene contact;
  contact.law = ContactLaw::contensou;
  contact.model = "ellipsoid";
  contact.radius = 1e-3;
  for (const auto& [pressure, axis] : {std::pair{"uniform", 2.0 / 3}, std::pair{"hertz", 0.58904862254808623},
                                       std::pair{"power:1", 8.0 / 15}}) {
    contact.pressure = pressure;
    const AnyFriction friction = make_friction(contact);
    REQUIRE(is_ball<EllipsoidLaw>(friction));
    const auto& ball = std::get<FrictionBall<SmoothPlate<EllipsoidLaw>>>(friction);
    CHECK(ball.support(1, {0, 0, 1}) == Approx(axis).epsilon(1e-14));
    CHECK(ball.support(1, {1, 0, 0}) == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("Simulation: the tippe-top starts as its scene says", "[scene]") {
  for (const char* formulation : {"scene.formulation=axis", "scene.formulation=euler"}) {
    const Simulation simulation = compose(changed({formulation}));
    CHECK(simulation.t_end == 8);
    CHECK(simulation.state.t == 0);
    CHECK(told(simulation, "gap_body") == 0);
    // z_S = 0.015 - 0.003 cos(0.1); gap of the tip z_S + 0.016 cos(0.1) - 0.005 = 0.01 + 0.013 cos(0.1)
    CHECK(told(simulation, "z_s") == Approx(0.012014987504165923).epsilon(1e-15));
    CHECK(told(simulation, "gap_tip") == Approx(0.022935054148614335).epsilon(1e-15));
    CHECK(told(simulation, "theta") == Approx(0.1).epsilon(1e-15));
    CHECK(told(simulation, "omega_z") == Approx(180 * 0.99500416527802577).epsilon(1e-15));
    // 7e-7/2 180^2 + 6e-3 9.81 z_S
    CHECK(told(simulation, "energy") == Approx(0.01134 + 5.886e-2 * 0.012014987504165923).epsilon(1e-14));
  }
  CHECK(dynamic_cast<const TippeTopAxis*>(compose(changed({})).system.get()) != nullptr);
  CHECK(dynamic_cast<const TippeTopEuler*>(compose(changed({"scene.formulation=euler"})).system.get()) !=
        nullptr);
}

TEST_CASE("Simulation: the printed height of LG03 5.4 is 12.5 nm above the floor", "[scene]") {
  // 1.2015e-2 - 1.5e-2 + 0.3e-2 cos(0.1) = 1.2495834077e-8, of which rounding of z_S leaves 1e-18
  CHECK(told(compose(changed({"initial.z_s=1.2015e-2"})), "gap_body") ==
        Approx(1.2495834077e-8).epsilon(1e-9));
}

TEST_CASE("Simulation: the effects that run", "[scene]") {
  using Names = std::vector<std::string>;
  CHECK(effects(changed({})) == Names{"gravity", "unilateral contact", "sliding friction",
                                      "drilling friction", "coupling of sliding and drilling"});
  CHECK(effects(changed({"contact.body={law=\"frictionless\"}", "contact.tip={law=\"coulomb\", mu=0.1}",
                         "scene.gravity=0"})) == Names{"unilateral contact", "sliding friction"});
  const Scene limit = changed({"contact.body.radius=0", "contact.body.restitution=0.5"});
  CHECK(effects(top_of(limit).contacts[0]) == Names{"unilateral contact", "restitution", "sliding friction"});
}

TEST_CASE("Simulation: bodies with every pair watched start as their scene says", "[scene]") {
  const Simulation simulation = compose(test::changed({}));
  CHECK(dynamic_cast<const RigidBodies*>(simulation.system.get()) != nullptr);
  CHECK(simulation.contacts.size() == 29);
  CHECK(simulation.contacts[0] == "top");
  CHECK(simulation.contacts[28] == "hulls_2");
  CHECK(simulation.works == std::vector<std::string>{"air drag", "load push"});
  std::vector<double> row;
  const std::vector<ContactMode> modes(29, ContactMode::open);
  simulation.describe({0, simulation.state.q, simulation.state.u, modes}, row);
  REQUIRE(row.size() == 7);
  CHECK(row[0] == 0.5);  // top.x
  CHECK(row[2] == 0);    // gap_top: touching
  CHECK(row[3] == 0);    // slip_slide
  CHECK(row[5] == 2.5);  // top.z
  CHECK(row[4] == simulation.energy(simulation.state));
}

TEST_CASE("Simulation: the names of contacts are those of the system", "[scene]") {
  const Scene scene = test::changed({});
  const Simulation simulation = compose(scene);
  const std::vector<PairName> pairs = pair_names(test::bodies_of(scene));
  REQUIRE(pairs.size() == simulation.contacts.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) CHECK(pairs[i].name == simulation.contacts[i]);
}

TEST_CASE("Simulation: nscd runs the same scene without events", "[scene]") {
  const Scene scene =
      test::changed({{"outcome", "output.columns"},
                     {"integrator.method=nscd", "integrator.step=1e-3", "scene.duration=0.01"}});
  Simulation simulation = compose(scene);
  CHECK(simulation.system == nullptr);
  CHECK(simulation.contacts == std::vector<std::string>{"top", "slide", "pile", "walls", "hulls"});
  CHECK(simulation.works == std::vector<std::string>{"air drag", "load push"});
  CHECK(simulation.columns == std::vector<std::string>{"highest", "energy"});
  const Outcome outcome = run(simulation);
  CHECK(outcome.report.status == RunStatus::finished);
  CHECK(outcome.t == 0.01);
  CHECK(outcome.report.work.size() == 2);
  CHECK(outcome.report.dissipated.size() == 5);
}

TEST_CASE("Simulation: a radius that follows the load is written in the one under the weight", "[scene]") {
  // (3 rho W/(4 E*))^(1/3) with rho = 1/4, the smallest sphere, and W = 2 kg sqrt(1 + 9.81^2) m/s^2, the
  // heaviest body; what a pair makes of it is by its own radii: 1 and 1/2 in the hulls', so rho* = 1/2 and
  // 1/3.
  const Simulation simulation =
      compose(test::changed({{},
                             {"contact.hulls.radius=hertz", "contact.hulls.modulus=2e9",
                              "integrator.method=moreau", "integrator.step=1e-3"}}));
  const auto& contacts = simulation.system->contacts();
  const double weight = 2 * std::sqrt(1 + 9.81 * 9.81);
  CHECK(contacts[28].radius == Approx(std::cbrt(0.75 * 0.25 * weight / 2e9)).epsilon(1e-14));
  REQUIRE(contacts[28].load_radius);
  const double one = contacts[27].load_radius->relative_radius,
               other = contacts[28].load_radius->relative_radius;
  CHECK(std::min(one, other) == Approx(1.0 / 3).epsilon(1e-14));
  CHECK(std::max(one, other) == Approx(0.5).epsilon(1e-14));
}

TEST_CASE("Simulation: the shipped scenes of bodies are read and composed", "[scene]") {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CONTENSOU_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path());
    const Simulation simulation = compose(read_scene(read_document(entry.path())));
    CHECK(simulation.columns.size() > 0);
    ++scenes;
  }
  CHECK(scenes >= 9);
}
