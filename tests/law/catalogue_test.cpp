#include "contensou/law/catalogue.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <string>

using namespace contensou;

namespace {

double extent_eta(const AnyLaw& law) {
  return std::visit([](const auto& l) { return l.extent().eta; }, law);
}

template <class Law>
bool is(const AnyLaw& law) {
  return std::holds_alternative<Law>(law);
}

}  // namespace

TEST_CASE("Pressures by name", "[law][catalogue]") {
  CHECK(pressure_exponent("uniform") == 0);
  CHECK(pressure_exponent("hertz") == 0.5);
  CHECK(pressure_exponent("power:1") == 1);
  CHECK(pressure_exponent("power:-0.5") == -0.5);
  CHECK(pressure_exponent("power:2.5e-1") == 0.25);
  CHECK(pressure_exponent("power:1e6") == 1e6);
}

TEST_CASE("A wrong pressure is named with what was expected", "[law][catalogue]") {
  CHECK_THROWS_WITH(pressure_exponent("power:-2"), "power:-2: expected power:N with N > -1");
  CHECK_THROWS_WITH(pressure_exponent("power:-1"), "power:-1: expected power:N with N > -1");
  for (const char* text :
       {"power:", "power:x", "power:1x", "power: 1", "power:nan", "power:inf", "power:1e999", "power:0x1"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(pressure_exponent(text), std::string(text) + ": expected power:N with N > -1");
  }
  CHECK_THROWS_WITH(pressure_exponent("power:2e6"), "power:2e6: expected power:N with N <= 1e6");
  for (const char* text : {"", "Uniform", "parabolic", "power", "uniform ", "hertz:1"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(pressure_exponent(text),
                      std::string(text) + ": expected uniform, hertz (the paper's parabolic) or power:N");
  }
  CHECK_THROWS_AS(pressure_exponent("x"), std::invalid_argument);
}

TEST_CASE("Models by name", "[law][catalogue]") {
  CHECK(is<UniformLaw>(make_law("uniform")));
  CHECK(is<HertzLaw>(make_law("hertz", "exact")));
  CHECK(is<PowerLaw>(make_law("power:1")));
  CHECK(is<UniformLaw>(make_law("power:0")));
  CHECK(is<HertzLaw>(make_law("power:0.5")));
  CHECK(is<PrintedUniformLaw>(make_law("uniform", "series")));
  CHECK(is<SeriesLaw>(make_law("hertz", "series")));
  CHECK(std::get<SeriesLaw>(make_law("hertz", "series")).inner().size() == 4);
  CHECK(std::get<SeriesLaw>(make_law("power:1", "series")).outer()[1] == Approx(1. / 12));
  CHECK(std::get<SeriesLaw>(make_law("uniform", "series:17")).inner().size() == 17);
  CHECK(is<PrintedUniformLaw>(make_law("uniform", "printed")));
  CHECK(is<PrintedHertzLaw>(make_law("hertz", "printed")));
  CHECK(is<EllipsoidLaw>(make_law("power:3", "ellipsoid")));
  CHECK(is<DecoupledLaw>(make_law("uniform", "decoupled")));
  CHECK(is<PadeLaw>(make_law("uniform", "pade")));
  CHECK(is<PadeLaw>(make_law("hertz", "pade2")));
  CHECK(is<TanhLaw>(make_law("uniform", "tanh:0.001")));
}

TEST_CASE("Every model has the semi-axes of the exact law", "[law][catalogue]") {
  for (const char* model :
       {"exact", "series", "series:2", "ellipsoid", "decoupled", "pade", "pade2", "tanh:1e-3"}) {
    CAPTURE(model);
    CHECK(extent_eta(make_law("uniform", model)) == Approx(2. / 3).epsilon(1e-15));
    CHECK(extent_eta(make_law("hertz", model)) == Approx(3 * std::numbers::pi / 16).epsilon(1e-15));
    CHECK(extent_eta(make_law("power:1", model)) == Approx(8. / 15).epsilon(1e-14));
  }
  // Constants of the Padé forms: slope 3π/8 and tail 1/5 for Hertz.
  const auto pade = std::get<PadeLaw>(make_law("hertz", "pade"));
  CHECK(pade.curvature(0.0, 1.0).vv == Approx(3 * std::numbers::pi / 8).epsilon(1e-15));
  CHECK(pade.curvature(1.0, 0.0).ss == Approx(0.2).epsilon(1e-15));
}

TEST_CASE("A wrong model is named with what was expected", "[law][catalogue]") {
  CHECK_THROWS_WITH(
      make_law("uniform", "elipsoid"),
      "elipsoid: expected exact, series, series:K, printed, ellipsoid, decoupled, pade, pade2 or tanh:EPS");
  CHECK_THROWS_WITH(make_law("power:1", "printed"),
                    "power:1: expected uniform or hertz, for which the paper prints formulas");
  for (const char* model :
       {"series:0", "series:1001", "series:-3", "series:2.5", "series:", "series:x", "series:4 "}) {
    CAPTURE(model);
    CHECK_THROWS_WITH(make_law("uniform", model),
                      std::string(model) + ": expected series:K with a whole K from 1 to 1000");
  }
  for (const char* model : {"tanh:0", "tanh:-1", "tanh:nan", "tanh:inf", "tanh:", "tanh:1 m"}) {
    CAPTURE(model);
    CHECK_THROWS_WITH(make_law("uniform", model),
                      std::string(model) + ": expected tanh:EPS with EPS > 0 in m/s");
  }
  CHECK_THROWS_AS(make_law("uniform", ""), std::invalid_argument);
  CHECK_THROWS_AS(make_law("power:-1", "series"), std::invalid_argument);
}

TEST_CASE("Help names every pressure and model", "[law][catalogue]") {
  for (const char* name : {"uniform", "hertz", "power:N"}) CHECK_THAT(pressure_help(), Catch::Contains(name));
  for (const char* name :
       {"exact", "series", "series:K", "printed", "ellipsoid", "decoupled", "pade", "pade2", "tanh:EPS"}) {
    CHECK_THAT(model_help(), Catch::Contains(name));
  }
}
