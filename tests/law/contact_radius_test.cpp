#include "contensou/law/contact_radius.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "doubles.hpp"

using namespace contensou;

TEST_CASE("A steel ball of 10 mm radius on a steel plane under 100 N", "[law][contact_radius]") {
  // By hand, E = 210 GPa, nu = 0.3: E* = 210e9/(2 · 0.91) = 1.153846153846e11 Pa (= 1.5/1.3 · 1e11), ρ* =
  // 0.01 m, R³ = 3 · 0.01 · 100/(4 · 1.153846...e11) = 6.5e-12 m³, R = 6.5^(1/3) 1e-4 m
  // = 1.8662555784086241e-4 m.
  const ElasticBody ball{.radius = 0.01, .modulus = 210e9, .poisson = 0.3};
  const ElasticBody plane{.radius = inf, .modulus = 210e9, .poisson = 0.3};
  CHECK(effective_modulus(ball, plane) == Approx(1.5e11 / 1.3).epsilon(1e-15));
  CHECK(relative_radius(ball, plane) == 0.01);
  const double radius = hertz_contact_radius(ball, plane, 100);
  CHECK(radius == Approx(1.8662555784086241e-4).epsilon(1e-14));
  CHECK(radius * radius * radius == Approx(6.5e-12).epsilon(1e-14));
}

TEST_CASE("Limits and symmetries of the Hertz radius", "[law][contact_radius]") {
  const ElasticBody soft{.radius = 0.02, .modulus = 5e6, .poisson = 0.5};
  const ElasticBody rigid{.radius = inf, .modulus = inf, .poisson = 0.0};
  CHECK(effective_modulus(soft, rigid) == Approx(5e6 / 0.75).epsilon(1e-15));
  CHECK(effective_modulus(rigid, rigid) == inf);
  CHECK(hertz_contact_radius(soft, rigid, 0) == 0);
  CHECK(hertz_contact_radius({0.1, inf, 0}, rigid, 10) == 0);
  CHECK(hertz_contact_radius(soft, rigid, 3) == hertz_contact_radius(rigid, soft, 3));
  // R ∝ λ_N^{1/3}.
  CHECK(hertz_contact_radius(soft, rigid, 8) ==
        Approx(2 * hertz_contact_radius(soft, rigid, 1)).epsilon(1e-14));
}

TEST_CASE("Relative radius of two balls, and of a ball in a hollow", "[law][contact_radius]") {
  const auto body = [](double radius) { return ElasticBody{radius, 1e9, 0.3}; };
  CHECK(relative_radius(body(2), body(2)) == 1);
  CHECK(relative_radius(body(3), body(6)) == Approx(2).epsilon(1e-15));
  CHECK(relative_radius(body(1), body(-2)) == Approx(2).epsilon(1e-15));
  CHECK(relative_radius(body(-2), body(1)) == Approx(2).epsilon(1e-15));
  // A hollow larger by 2^-40: 1/ρ* = 1 − 1/(1 + 2^-40), ρ* = 2^40 + 1 exactly.
  CHECK(relative_radius(body(1), body(-(1 + 0x1p-40))) == 0x1p40 + 1);
  CHECK(relative_radius(body(1.7e308), body(1.7e308)) == Approx(0.85e308).epsilon(1e-15));
  CHECK(relative_radius(body(inf), body(5)) == 5);
}

TEST_CASE("Contact radius where products of radius, load and compliance are no doubles",
          "[law][contact_radius]") {
  const auto both = [](double r, double e) { return ElasticBody{r, e, 0}; };
  // ρ* = r/2, E* = E/2: R³ = (3/4) r λ/E.
  const auto radius = [&](double r, double e, double force) {
    return hertz_contact_radius(both(r, e), both(r, e), force);
  };
  CHECK(radius(1e-310, 1e-309, 0) == 0);
  CHECK(radius(1e300, 1e-300, 1e300) == Approx(std::cbrt(0.75) * 1e300).epsilon(1e-15));
  CHECK(radius(1e-300, 1e300, 1e-300) == Approx(std::cbrt(0.75) * 1e-300).epsilon(1e-15));
  CHECK(radius(1e-300, 1e-300, 1e-300) == Approx(std::cbrt(0.75) * 1e-100).epsilon(1e-15));
  CHECK(relative_radius(both(3 * smallest, 1), both(6 * smallest, 1)) == 2 * smallest);
}

TEST_CASE("Contact radius refuses what is no contact", "[law][contact_radius]") {
  const ElasticBody good{.radius = 1, .modulus = 1e9, .poisson = 0.3};
  const auto radius = [&](double r) { return ElasticBody{r, 1e9, 0.3}; };
  for (const double r : {0.0, not_a_number, -inf})
    CHECK_THROWS_AS(relative_radius(good, radius(r)), std::invalid_argument);
  // Conforming: two planes, a hollow of the same or a smaller radius, two hollows, a hollow on a plane.
  CHECK_THROWS_WITH(relative_radius(radius(inf), radius(inf)), Catch::Contains("conform"));
  CHECK_THROWS_WITH(relative_radius(radius(1), radius(-1)), Catch::Contains("conform"));
  CHECK_THROWS_WITH(relative_radius(radius(-1), radius(1)), Catch::Contains("conform"));
  CHECK_THROWS_WITH(relative_radius(radius(1), radius(-0.5)), Catch::Contains("conform"));
  CHECK_THROWS_WITH(relative_radius(radius(-1), radius(-3)), Catch::Contains("conform"));
  CHECK_THROWS_WITH(relative_radius(radius(-1), radius(inf)), Catch::Contains("conform"));
  for (const double e : {0.0, -1.0, not_a_number})
    CHECK_THROWS_AS(effective_modulus(good, {1, e, 0.3}), std::invalid_argument);
  for (const double nu : {-1.0, 0.51, not_a_number}) {
    CHECK_THROWS_AS(effective_modulus(good, {1, 1e9, nu}), std::invalid_argument);
  }
  for (const double force : {-1.0, inf, not_a_number}) {
    CHECK_THROWS_AS(hertz_contact_radius(good, good, force), std::invalid_argument);
  }
  CHECK_THROWS_WITH(hertz_contact_radius(good, good, -2), Catch::Contains("normal force -2"));
}
