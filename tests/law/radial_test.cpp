#include "contensou/law/radial.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "contensou/law/hertz.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/uniform.hpp"
#include "doubles.hpp"

using namespace contensou;

namespace {

const std::vector<double> ratios{0.0, 1e-12, 1e-3, 0.3, 0.5, 0.999, 1.0, 1.001, 2.0, 40.0, 1e6, 1e200};

/// The accuracy radial.hpp states, for ξ and η.
constexpr double stated = 1e-13;

void check_same(const RadialLaw& radial, const auto& law) {
  for (const double u : ratios) {
    CAPTURE(u);
    CHECK(radial.at(u, 1).xi == Approx(law.at(u, 1).xi).epsilon(stated));
    CHECK(radial.at(u, 1).eta == Approx(law.at(u, 1).eta).epsilon(stated));
  }
  CHECK(radial.at(1, 0).xi == Approx(1).epsilon(stated));
  CHECK(radial.at(1, 0).eta == 0);
  CHECK(radial.extent().eta == Approx(law.extent().eta).epsilon(stated));
}

}  // namespace

TEST_CASE("Radial pressures whose law is known otherwise", "[law][radial]") {
  SECTION("uniform") {
    check_same(RadialLaw({[](double) { return 7.0; }, {}}), UniformLaw{});
  }
  SECTION("Hertz") {
    check_same(RadialLaw({[](double rho) { return std::sqrt((1 - rho) * (1 + rho)); }, {}}), HertzLaw{});
  }
  SECTION("paraboloid") {
    check_same(RadialLaw({[](double rho) { return 1e-3 * (1 - rho) * (1 + rho); }, {}}), PowerLaw(1));
  }
}

TEST_CASE("An annulus is a disc less a smaller disc", "[law][radial]") {
  // σ = 1 on a < ρ/R < 1. Potentials add up: (1 − a²) Φ(v, s) = Φ_disc(v, s) − a² Φ_disc(v, a s), and so
  // (1 − a²) ξ = ξ_disc(v, s) − a² ξ_disc(v, a s), (1 − a²) η = η_disc(v, s) − a³ η_disc(v, a s).
  const double a = 0.5;
  const RadialLaw annulus({[a](double rho) { return rho < a ? 0.0 : 1.0; }, {a}});
  const UniformLaw disc;
  for (const double u : {0.1, 0.4, 0.5, 0.6, 1.0, 1.5, 10.0}) {
    CAPTURE(u);
    const auto whole = disc.at(u, 1);
    const auto hole = disc.at(u, a);
    CHECK(annulus.at(u, 1).xi == Approx((whole.xi - a * a * hole.xi) / (1 - a * a)).epsilon(2 * stated));
    CHECK(annulus.at(u, 1).eta ==
          Approx((whole.eta - a * a * a * hole.eta) / (1 - a * a)).epsilon(2 * stated));
  }
  // ∫ρ² dρ/∫ρ dρ over the annulus: (2/3)(1 − a³)/(1 − a²) = 7/9.
  CHECK(annulus.extent().eta == Approx(7. / 9).epsilon(stated));
}

TEST_CASE("Second derivatives of a radial law", "[law][radial]") {
  const RadialLaw radial({[](double rho) { return std::sqrt((1 - rho) * (1 + rho)); }, {}});
  for (const double u : {1e-6, 0.3, 0.9, 1.1, 3.0, 1e6}) {
    CAPTURE(u);
    const auto a = radial.curvature(u, 1);
    const auto b = HertzLaw{}.curvature(u, 1);
    // D(m) of a ring has a logarithm at ρ = R*, which tanh-sinh integrates with a few digits to spare.
    CHECK(a.vv == Approx(b.vv).epsilon(1e-10));
    CHECK(a.vs == Approx(b.vs).epsilon(1e-10));
    CHECK(a.ss == Approx(b.ss).epsilon(1e-10));
  }
}

TEST_CASE("A pressure from a table", "[law][radial]") {
  // The cone σ = 1 − ρ: η_max = ∫(1−ρ)ρ² dρ/∫(1−ρ)ρ dρ =
  // (1/12)/(1/6) = 1/2; f''(0) = ∫(1−ρ) dρ/(2 · 1/6) = 3/2.
  const RadialPressure cone = tabulated_pressure({0, 0.25, 1}, {1, 0.75, 0});
  CHECK(cone.breaks == std::vector<double>{0.25});
  CHECK(cone.sigma(0.0) == 1);
  CHECK(cone.sigma(0.125) == 0.875);
  CHECK(cone.sigma(0.25) == 0.75);
  CHECK(cone.sigma(0.5) == Approx(0.5));
  CHECK(cone.sigma(1.0) == 0);
  const RadialLaw law(cone);
  CHECK(law.extent().eta == Approx(0.5).epsilon(stated));
  CHECK(law.at(1e-12, 1).xi ==
        Approx(1.5e-12).epsilon(1e-11));  // the next term is u |ln u| relative for a cone
}

TEST_CASE("Pressures and ratios near the ends of the doubles", "[law][radial]") {
  const Friction exact = UniformLaw{}.at(0.5, 1.0);
  for (const double sigma : {smallest, 1e-310, 1e-200, 1e200, 1e308, largest}) {
    CAPTURE(sigma);
    const RadialLaw law(tabulated_pressure({0, 1}, {sigma, sigma}));
    CHECK(law.at(0.5, 1.0).xi == Approx(exact.xi).epsilon(stated));
    CHECK(law.at(0.5, 1.0).eta == Approx(exact.eta).epsilon(stated));
  }
  const RadialLaw cone(tabulated_pressure({0, 1}, {1, 0}));
  for (const double u : {smallest, 1e-310, 1e-300}) {
    CAPTURE(u);
    CHECK(std::abs(cone.at(u, 1).xi - 1.5 * u) <= 1e-13 * u + smallest);
    CHECK(cone.at(u, 1).eta == Approx(0.5).epsilon(stated));
    CHECK(cone.curvature(u, 1).vv == Approx(1.5).epsilon(1e-10));
  }
}

TEST_CASE("Compiled on request, within the bound it states", "[law][radial]") {
  const RadialLaw radial({[](double rho) { return 1 + rho; }, {}});
  const CompiledLaw compiled = radial.compile(1e-9);
  CHECK(compiled.error_bound() <= 1e-9);
  CHECK(compiled.extent().eta == radial.extent().eta);
  for (double u = 1e-3; u < 1e3; u *= 1.83) {
    CAPTURE(u);
    CHECK(compiled.at(u, 1).xi == Approx(radial.at(u, 1).xi).epsilon(1e-9));
    CHECK(compiled.at(u, 1).eta == Approx(radial.at(u, 1).eta).epsilon(1e-9));
  }
}

TEST_CASE("Pressures that are none are refused", "[law][radial]") {
  const auto law = [](auto sigma, std::vector<double> breaks = {}) {
    return RadialLaw({sigma, std::move(breaks)});
  };
  CHECK_THROWS_AS(law([](double) { return 0.0; }), std::invalid_argument);
  CHECK_THROWS_AS(law([](double rho) { return 0.5 - rho; }), std::invalid_argument);
  CHECK_THROWS_AS(law([](double) { return not_a_number; }), std::invalid_argument);
  CHECK_THROWS_AS(law([](double) { return inf; }), std::invalid_argument);
  for (const double b : {0.0, 1.0, -0.5, not_a_number}) {
    CHECK_THROWS_AS(law([](double) { return 1.0; }, {b}), std::invalid_argument);
  }
  const RadialLaw good = law([](double) { return 1.0; });
  CHECK_THROWS_AS(good.at(0, 0), std::domain_error);
  CHECK_THROWS_AS(good.at(not_a_number, 1), std::domain_error);
  CHECK_THROWS_AS(good.curvature(inf, inf), std::domain_error);

  CHECK_THROWS_AS(tabulated_pressure({0, 1}, {1}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_pressure({0}, {1}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_pressure({0.1, 1}, {1, 1}), std::invalid_argument);
  CHECK_THROWS_AS(tabulated_pressure({0, 0.9}, {1, 1}), std::invalid_argument);
  CHECK_THROWS_WITH(tabulated_pressure({0, 0.5, 0.5, 1}, {1, 1, 1, 1}), Catch::Contains("entry 3"));
  CHECK_THROWS_WITH(tabulated_pressure({0, 0.5, 1}, {1, -1, 1}), Catch::Contains("entry 2"));
  CHECK_THROWS_AS(tabulated_pressure({0, not_a_number, 1}, {1, 1, 1}), std::invalid_argument);
}
