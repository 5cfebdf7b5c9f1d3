#include "contensou/law/compiled.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "contensou/law/approximations.hpp"
#include "doubles.hpp"

using namespace contensou;

namespace {

/// Bounded forms of the ellipsoid, written here from Φ = √(a²v²
/// + b²s²): inner h = √(a²u² + b²), outer h = √(a² + b²w²).
constexpr double a = 1.0;
constexpr double b = 0.6;
BoundedForm form(double h) { return {a * a / h, b * b / h, a * a * b * b / (h * h * h)}; }
BoundedForm inner(SlipRatio u) { return form(std::hypot(a * u.x, b)); }
BoundedForm outer(SlipRatio w) { return form(std::hypot(a, b * w.x)); }

}  // namespace

TEST_CASE("A compiled law keeps the bound it states", "[law][compiled]") {
  const EllipsoidLaw exact({a, b});
  std::size_t last_pieces = 0;
  for (const double tolerance : {1e-4, 1e-8, 1e-14}) {
    CAPTURE(tolerance);
    const CompiledLaw law(inner, outer, {a, b}, tolerance);
    CHECK(law.error_bound() <= tolerance);
    CHECK(law.pieces() >= 2);
    CHECK(law.pieces() >= last_pieces);
    last_pieces = law.pieces();
    CHECK(law.extent().eta == b);
    // A few ulp for the reference itself.
    const double bound = tolerance + 2e-15;
    for (double u = 1e-6; u < 1e6; u *= 1.0173) {
      CHECK(law.at(u, 1).xi == Approx(exact.at(u, 1).xi).epsilon(bound));
      CHECK(law.at(u, 1).eta == Approx(exact.at(u, 1).eta).epsilon(bound));
      CHECK(law.curvature(u, 1).vv == Approx(exact.curvature(u, 1).vv).epsilon(1e3 * bound));
    }
    CHECK(law.at(0, 2).eta == Approx(b).epsilon(bound));
    CHECK(law.at(2, 0).xi == Approx(a).epsilon(bound));
    CHECK(law.at(3, 3).xi == Approx(exact.at(3, 3).xi).epsilon(bound));
    CHECK_THROWS_AS(law.at(0, 0), std::domain_error);
    CHECK_THROWS_AS(law.curvature(inf, inf), std::domain_error);
  }
}

TEST_CASE("A kink that is declared costs little", "[law][compiled]") {
  // torque |u − 0.3| + 1 inside: straight on either side, so that a known break costs one piece more.
  const auto straight = [](SlipRatio u) { return BoundedForm{1, 1 + u.x, 1}; };
  const auto kinked = [](SlipRatio u) { return BoundedForm{1, 1 + std::abs(u.x - 0.3), 1}; };
  const auto flat = [](SlipRatio) { return BoundedForm{1, 1.7, 1}; };
  const CompiledLaw declared(kinked, flat, {1, 1.7}, 1e-12, {0.3});
  const CompiledLaw undeclared(kinked, flat, {1, 1.7}, 1e-12);
  CHECK(declared.pieces() == CompiledLaw(straight, flat, {1, 2}, 1e-12).pieces() + 1);
  CHECK(undeclared.pieces() > declared.pieces());
  for (double u = 0.01; u < 1; u += 0.0171) {
    CHECK(declared.at(u, 1).eta == Approx(1 + std::abs(u - 0.3)).epsilon(1e-12));
    CHECK(undeclared.at(u, 1).eta == Approx(1 + std::abs(u - 0.3)).epsilon(1e-12));
  }
}

TEST_CASE("Laws that are noise or no numbers are refused, and soon", "[law][compiled]") {
  int calls = 0;
  const auto noisy = [&](SlipRatio u) {
    ++calls;
    return BoundedForm{1 + 1e-9 * std::sin(1e15 * u.x), 1, 1};
  };
  CHECK_THROWS_AS(CompiledLaw(noisy, outer, {a, b}, 1e-12), std::runtime_error);
  CHECK(calls < 100000);
  const auto gap = [](SlipRatio u) { return BoundedForm{1, u.x > 0.2 && u.x < 0.3 ? not_a_number : 1, 1}; };
  CHECK_THROWS_AS(CompiledLaw(gap, outer, {a, b}, 1e-3), std::runtime_error);
}

TEST_CASE("No compiled law leaves its extent", "[law][compiled]") {
  const auto rounded_up = [](SlipRatio) { return BoundedForm{a * (1 + 1e-15), b * (1 + 1e-15), 1}; };
  const CompiledLaw law(rounded_up, rounded_up, {a, b}, 1e-12);
  CHECK(law.at(1, 0).xi == a);
  CHECK(law.at(0, 1).eta == b);
}

TEST_CASE("Tolerances out of reach are refused", "[law][compiled]") {
  for (const double tolerance : {0.0, 1e-17, -1.0, 1.0, not_a_number}) {
    CHECK_THROWS_AS(CompiledLaw(inner, outer, {a, b}, tolerance), std::invalid_argument);
  }
}
