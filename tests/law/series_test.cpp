#include "contensou/law/series.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "doubles.hpp"

using namespace contensou;

namespace {

constexpr double pi = std::numbers::pi;

/// The printed coefficients, written out as the paper has them: LG03 (2.8), (2.13), (2.14).
double uniform_phi(double u) {
  if (u <= 1) return 2. / 3 + std::pow(u, 2) / 2 - std::pow(u, 4) / 32 - std::pow(u, 6) / 384;
  return u + 1 / (8 * u) + 1 / (192 * std::pow(u, 3)) + 1 / (1024 * std::pow(u, 5));
}
double uniform_xi(double u) {
  if (u <= 1) return u - std::pow(u, 3) / 8 - std::pow(u, 5) / 64;
  return 1 - 1 / (8 * std::pow(u, 2)) - 1 / (64 * std::pow(u, 4)) - 5 / (1024 * std::pow(u, 6));
}
double uniform_eta(double u) {
  if (u <= 1) return 2. / 3 - std::pow(u, 2) / 2 + 3 * std::pow(u, 4) / 32 + 5 * std::pow(u, 6) / 384;
  return 1 / (4 * u) + 1 / (48 * std::pow(u, 3)) + 3 / (512 * std::pow(u, 5));
}

const std::vector<double> ratios{0.0, 1e-9, 0.1, 0.5, 0.9,  1.0, std::nextafter(1.0, 2.0),
                                 1.1, 2.0,  7.5, 1e6, 1e150};

}  // namespace

// A sum of four terms, each rounded a few times, the largest
// not above the sum by more than a factor 2: 10 ε holds it.
constexpr double rounding = 10 * std::numeric_limits<double>::epsilon();

TEST_CASE("PrintedUniformLaw is (2.8), (2.13), (2.14) to the letter", "[law][series]") {
  const PrintedUniformLaw law;
  for (const double u : ratios) {
    CAPTURE(u);
    const auto [xi, eta] = law.at(u, 1.0);
    CHECK(std::abs(xi - uniform_xi(u)) <= rounding * uniform_xi(u));
    CHECK(std::abs(eta - uniform_eta(u)) <= rounding * uniform_eta(u));
    CHECK(std::abs(potential(law, u, 1.0) - uniform_phi(u)) <= rounding * uniform_phi(u));
  }
  CHECK(law.at(1.0, 0.0).xi == 1.0);
  CHECK(law.at(1.0, 0.0).eta == 0.0);
  CHECK(law.at(0.0, 1.0).eta == 2.0 / 3);
}

TEST_CASE("Four terms of the series of n = 0 are the printed ones", "[law][series]") {
  const SeriesLaw law(0, 4);
  const std::vector<double> inner{2. / 3, 1. / 2, -1. / 32, -1. / 384};
  const std::vector<double> outer{1, 1. / 8, 1. / 192, 1. / 1024};
  REQUIRE(law.inner().size() == 4);
  REQUIRE(law.outer().size() == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(law.inner()[k] == Approx(inner[k]).epsilon(4e-15).margin(0));
    CHECK(law.outer()[k] == Approx(outer[k]).epsilon(4e-15).margin(0));
  }
  for (const double u : ratios) {
    CAPTURE(u);
    const auto printed = PrintedUniformLaw{}.at(u, 1.0);
    const auto series = law.at(u, 1.0);
    CHECK(std::abs(series.xi - printed.xi) <= 2 * rounding * printed.xi);
    CHECK(std::abs(series.eta - printed.eta) <= 2 * rounding * printed.eta);
    const auto a = PrintedUniformLaw{}.curvature(u, 1.0);
    const auto b = law.curvature(u, 1.0);
    CHECK(std::abs(a.vv - b.vv) <= 2 * rounding * a.vv);
    CHECK(std::abs(a.vs - b.vs) <= 2 * rounding * -a.vs);
    CHECK(std::abs(a.ss - b.ss) <= 2 * rounding * a.ss);
  }
}

TEST_CASE("The coefficients of the Hertz series", "[law][series]") {
  const SeriesLaw law(0.5, 6);
  // Inner: (3.14) is a polynomial, 3π/128 (8 + 8u² − u⁴); further coefficients are exactly zero.
  CHECK(ulp_distance(law.inner()[0], 3 * pi / 16) <= 1);
  CHECK(ulp_distance(law.inner()[1], 3 * pi / 16) <= 4);
  CHECK(ulp_distance(law.inner()[2], -3 * pi / 128) <= 6);
  for (std::size_t k = 3; k < 6; ++k) CHECK(law.inner()[k] == 0);
  // Outer: arcsin and the root of (3.14) expanded by hand: 1, 1/10, 1/280, 1/1680, ...
  const std::vector<double> outer{1, 1. / 10, 1. / 280, 1. / 1680};
  for (std::size_t k = 0; k < 4; ++k) CHECK(law.outer()[k] == Approx(outer[k]).epsilon(4e-15).margin(0));
}

TEST_CASE("The coefficients of the paraboloid, n = 1", "[law][series]") {
  // σ = 2λ_N/(πR²) (1 − ρ²/R²). Inner: A = 2 B(3/2, 2) = 8/15; (−½)(−5/2)/1 = 5/4; (½)(−3/2)/4 = −3/16;
  // (3/2)(−½)/9 = −1/12. Outer: (1/4)/3; (1/4)/(4·2); (9/4)/(5·3).
  const SeriesLaw law(1, 4);
  const std::vector<double> inner{8. / 15, 2. / 3, -1. / 8, 1. / 96};
  const std::vector<double> outer{1, 1. / 12, 1. / 384, 1. / 2560};
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(law.inner()[k] == Approx(inner[k]).epsilon(4e-15).margin(0));
    CHECK(law.outer()[k] == Approx(outer[k]).epsilon(4e-15).margin(0));
  }
}

TEST_CASE("A long series meets the exact law away from u = 1", "[law][series]") {
  // At u = ½ and 2 the terms fall by 4 each and are below 1: 40 of them leave less than 4^-40 = 1e-24.
  const SeriesLaw uniform(0, 40);
  const SeriesLaw hertz(0.5, 40);
  for (const double u : {0.01, 0.25, 0.5, 2.0, 4.0, 1e3, 1e9}) {
    CAPTURE(u);
    CHECK(uniform.at(u, 1.0).xi == Approx(UniformLaw{}.at(u, 1.0).xi).epsilon(1e-14).margin(0));
    CHECK(uniform.at(u, 1.0).eta == Approx(UniformLaw{}.at(u, 1.0).eta).epsilon(1e-14).margin(0));
    CHECK(hertz.at(u, 1.0).xi == Approx(HertzLaw{}.at(u, 1.0).xi).epsilon(1e-14).margin(0));
    CHECK(hertz.at(u, 1.0).eta == Approx(HertzLaw{}.at(u, 1.0).eta).epsilon(1e-14).margin(0));
  }
}

TEST_CASE("More terms come closer at u = 1, from both sides", "[law][series]") {
  // Terms of ξ fall like k^-2 (k^-3 times 2k of Φ), so the rest after K terms falls like 1/K: ten times the
  // terms leave about a tenth of it.
  const double xi = 8 / (3 * pi);
  for (const double v : {1.0, std::nextafter(1.0, 2.0)}) {
    const double few = std::abs(SeriesLaw(0, 20).at(v, 1.0).xi - xi);
    const double many = std::abs(SeriesLaw(0, 200).at(v, 1.0).xi - xi);
    CHECK(many < few);
    CHECK(few / many > 5);
  }
}

TEST_CASE("One term: no coupling at all", "[law][series]") {
  const SeriesLaw law(0, 1);
  CHECK(law.at(0.5, 1.0).xi == 0);
  CHECK(law.at(0.5, 1.0).eta == law.extent().eta);
  CHECK(law.at(2.0, 1.0).xi == 1);
  CHECK(law.at(2.0, 1.0).eta == 0);
}

TEST_CASE("PrintedHertzLaw is (3.14), (3.17), (3.18) to the letter", "[law][series]") {
  const PrintedHertzLaw law;
  for (const double u : {0.0, 0.3, 1.0}) {
    CHECK(law.at(u, 1.0).xi == Approx(3 * pi / 32 * u * (4 - u * u)).epsilon(1e-15).margin(0));
    CHECK(law.at(u, 1.0).eta ==
          Approx(3 * pi / 128 * (3 * std::pow(u, 4) - 8 * u * u + 8)).epsilon(1e-15).margin(0));
  }
  // u = √2: arcsin = π/4, root = 1; ξ = 3/16 (2 √2 π/4 + 4/√2), η = 3/64 (4 π/4 − 0).
  const double u = std::numbers::sqrt2;
  CHECK(law.at(u, 1.0).xi == Approx(3. / 16 * (u * pi / 2 + 2 * u)).epsilon(1e-14));
  CHECK(law.at(u, 1.0).eta == Approx(3. / 64 * pi).epsilon(1e-14));
  // The potential is (3.14).
  const double phi = 3. / 64 * (20 * pi / 4 + 16);
  CHECK(potential(law, u, 1.0) == Approx(phi).epsilon(1e-14));
}

TEST_CASE("PrintedHertzLaw loses digits like u² and u⁴ and gives no NaN", "[law][series]") {
  const PrintedHertzLaw printed;
  const HertzLaw exact;
  for (const double u : {2.0, 10.0, 100.0, 1000.0}) {
    CAPTURE(u);
    const double eps = std::numeric_limits<double>::epsilon();
    // Terms of size (3/16) 3u² and (3/64) 6u³, each with at most five roundings.
    CHECK(std::abs(printed.at(u, 1.0).xi - exact.at(u, 1.0).xi) <= 5 * eps * u * u);
    CHECK(std::abs(printed.at(u, 1.0).eta - exact.at(u, 1.0).eta) <= 5 * eps * u * u * u);
  }
  for (double u = 1; u < 1e308; u *= 3) {
    CAPTURE(u);
    const auto [xi, eta] = printed.at(u, 1.0);
    CHECK(std::isfinite(xi));
    CHECK(std::isfinite(eta));
    const auto c = printed.curvature(u, 1.0);
    CHECK(std::isfinite(c.vv + c.vs + c.ss));
  }
  CHECK(printed.at(3.0, 0.0).xi == 1);
  CHECK(printed.at(3.0, 0.0).eta == 0);
  CHECK(printed.at(1e300, 1e-300).xi == 1);
  CHECK(printed.curvature(2.0, 0.0).ss == 0.1);
}

TEST_CASE("Series laws refuse what they cannot use", "[law][series]") {
  CHECK_THROWS_AS(SeriesLaw(-1, 4), std::invalid_argument);
  CHECK_THROWS_AS(SeriesLaw(not_a_number, 4), std::invalid_argument);
  CHECK_THROWS_AS(SeriesLaw(inf, 4), std::invalid_argument);
  CHECK_THROWS_AS(SeriesLaw(0, 0), std::invalid_argument);
  CHECK_THROWS_AS(SeriesLaw(0, 1001), std::invalid_argument);
  CHECK_NOTHROW(SeriesLaw(0, 1000));
  // Coefficients that are no doubles, and whose sums would be NaN.
  CHECK_NOTHROW(SeriesLaw(1000, 400));
  CHECK_THROWS_WITH(SeriesLaw(1e6, 100), Catch::Contains("at most"));
  CHECK_THROWS_AS(SeriesLaw(1e300, 4), std::invalid_argument);
  const SeriesLaw longest(1e6, 65);
  for (const double u : {0.0, 1e-3, 1.0}) {
    CHECK(std::isfinite(longest.at(u, 1.0).xi));
    CHECK(std::isfinite(longest.at(u, 1.0).eta));
    CHECK(std::isfinite(longest.curvature(u, 1.0).vv));
  }
  const auto refuses = [&](const auto& law) {
    CHECK_THROWS_AS(law.at(0.0, 0.0), std::domain_error);
    CHECK_THROWS_AS(law.at(not_a_number, 1.0), std::domain_error);
    CHECK_THROWS_AS(law.at(1.0, not_a_number), std::domain_error);
    CHECK_THROWS_AS(law.at(-1.0, 1.0), std::domain_error);
    CHECK_THROWS_AS(law.at(inf, inf), std::domain_error);
    CHECK_THROWS_AS(law.curvature(0.0, 0.0), std::domain_error);
    CHECK_THROWS_AS(law.curvature(not_a_number, 1.0), std::domain_error);
    CHECK_THROWS_AS(law.curvature(inf, inf), std::domain_error);
  };
  refuses(SeriesLaw(0, 4));
  refuses(PrintedUniformLaw{});
  refuses(PrintedHertzLaw{});
}
