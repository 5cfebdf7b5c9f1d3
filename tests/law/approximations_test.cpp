#include "contensou/law/approximations.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "contensou/law/power_limits.hpp"

#include "doubles.hpp"

using namespace contensou;

namespace {
// A handful of roundings.
constexpr double few = 8 * std::numeric_limits<double>::epsilon();

Approx about(double x) { return Approx(x).epsilon(few).margin(0); }

}  // namespace

TEST_CASE("The limits of the power family", "[law][power_limits]") {
  const auto uniform = power_limits(0);
  CHECK(uniform.eta_max == 2.0 / 3);
  CHECK(uniform.slope == 1);
  CHECK(uniform.tail == 0.25);
  const auto hertz = power_limits(0.5);
  CHECK(hertz.eta_max == 3 * std::numbers::pi / 16);
  CHECK(hertz.slope == 3 * std::numbers::pi / 8);
  CHECK(hertz.tail == 0.2);
  // A = (n+1) B(3/2, n+1), n = 1: 2 · 4/15; n = 2: 3 · 16/105; n = −½: B(3/2, ½)/2 = π/4.
  CHECK(power_limits(1).eta_max == about(8. / 15));
  CHECK(power_limits(1).slope == about(4. / 3));
  CHECK(power_limits(2).eta_max == about(16. / 35));
  CHECK(power_limits(-0.5).eta_max == about(std::numbers::pi / 4));
  // The general expression joins the two special ones: A has
  // slope −0.28 at n = 0, so 1e-9 away it moves by 3e-10.
  CHECK(power_limits(1e-9).eta_max == Approx(2. / 3).epsilon(1e-9));
  CHECK(power_limits(0.5 + 1e-9).eta_max == Approx(3 * std::numbers::pi / 16).epsilon(1e-9));
  // n → ∞: A = (√π/2) Γ(n+2)/Γ(n+5/2) → (√(π/n)/2) (1 − 7/(8n)
  // + ...), a concentrated load; n → −1: a thin ring, A → 1.
  CHECK(power_limits(1e6).eta_max ==
        Approx(std::sqrt(std::numbers::pi / 1e6) / 2 * (1 - 7. / 8e6)).epsilon(1e-11));
  CHECK(power_limits(-1 + 1e-12).eta_max == Approx(1).epsilon(1e-11));
  for (const double n : {-1.0, -2.0, not_a_number, inf})
    CHECK_THROWS_AS(power_limits(n), std::invalid_argument);
}

TEST_CASE("EllipsoidLaw: its forces lie on the ellipsoid, normal to it", "[law][approximations]") {
  const EllipsoidLaw law({1.0, 2.0 / 3});
  for (const double u : {1e-300, 1e-8, 0.3, 1.0, 1.7, 1e8, 1e300}) {
    CAPTURE(u);
    const auto [xi, eta] = law.at(u, 1.0);
    CHECK(xi * xi + 2.25 * eta * eta == about(1));
    // Normal: (ξ, η/(4/9)) ∥ (u, 1).
    CHECK(xi == about(2.25 * eta * u));
  }
  // u = 1: h = √(1 + 4/9) = √13/3.
  CHECK(law.at(1.0, 1.0).xi == about(3 / std::sqrt(13.0)));
  CHECK(law.at(1.0, 1.0).eta == about(4 / (3 * std::sqrt(13.0))));
  CHECK(potential(law, 1.0, 1.0) == about(std::sqrt(13.0) / 3));
  const auto c = law.curvature(1.0, 1.0);
  CHECK(c.vv == about(4. / 9 * 27 / (13 * std::sqrt(13.0))));
  CHECK(c.vs == about(-c.vv));
  CHECK(c.ss == about(c.vv));
  // Axes.
  CHECK(law.at(2.0, 0.0).xi == 1);
  CHECK(law.at(2.0, 0.0).eta == 0);
  CHECK(law.at(0.0, 2.0).eta == about(2. / 3));
  CHECK(law.curvature(2.0, 0.0).ss == about(4. / 9 / 2));
  CHECK(law.curvature(0.0, 2.0).vv == about(1.5 / 2));
  CHECK(law.at(inf, 1.0).xi == 1);
  CHECK(law.at(1.0, inf).eta == about(2. / 3));
  // Semi-axes whose squares are no doubles.
  CHECK(EllipsoidLaw({1e200, 1e200}).at(3.0, 4.0).xi == about(0.6e200));
  CHECK(EllipsoidLaw({1e-200, 1e-200}).at(3.0, 4.0).eta == about(0.8e-200));
}

TEST_CASE("DecoupledLaw: each part knows only itself", "[law][approximations]") {
  const DecoupledLaw law({1.0, 0.6});
  for (const double v : {smallest, 1e-3, 1.0, 1e300, inf}) {
    const auto [xi, eta] = law.at(v, 2.0);
    CHECK(xi == 1.0);
    CHECK(eta == 0.6);
  }
  CHECK(law.at(0.0, 1.0).xi == 0);
  CHECK(law.at(1.0, 0.0).eta == 0);
  CHECK(law.curvature(0.0, 1.0).vv == inf);
  CHECK(law.curvature(0.0, 1.0).ss == 0);
  CHECK(law.curvature(1.0, 0.0).ss == inf);
  CHECK(law.curvature(1.0, 2.0).vv == 0);
  CHECK(potential(law, 3.0, 5.0) == about(6));
}

TEST_CASE("PadeLaw meets values and slopes at both ends", "[law][approximations]") {
  for (const double n : {0.0, 0.5, 1.0}) {
    const auto limits = power_limits(n);
    for (const int order : {1, 2}) {
      CAPTURE(n, order);
      const PadeLaw law(order, limits.eta_max, limits.slope, limits.tail);
      CHECK(law.at(0.0, 1.0).xi == 0);
      CHECK(law.at(0.0, 1.0).eta == limits.eta_max);
      CHECK(law.at(1.0, 0.0).xi == 1);
      CHECK(law.at(1.0, 0.0).eta == 0);
      // The next terms are relative u and w (times constants below 4): at 1e-17 they are gone.
      CHECK(law.at(1e-17, 1.0).xi == about(1e-17 * limits.slope));
      CHECK(law.at(1.0, 1e-17).eta == about(1e-17 * limits.tail));
      CHECK(law.curvature(0.0, 2.0).vv == about(limits.slope / 2));
      CHECK(law.curvature(2.0, 0.0).ss == about(limits.tail / 2));
      CHECK(law.at(inf, 1.0).xi == 1);
      CHECK(law.at(1.0, inf).eta == limits.eta_max);
    }
    // Second order: η = η_max − f''(0) u²/2 + O(u³), with a third coefficient below 2.
    const PadeLaw second(2, limits.eta_max, limits.slope, limits.tail);
    const double u = 1e-4;
    CHECK(std::abs(second.at(u, 1.0).eta - (limits.eta_max - limits.slope * u * u / 2)) <= 2 * u * u * u);
  }
}

TEST_CASE("PadeLaw by hand, and without a seam at u = 1", "[law][approximations]") {
  // Uniform: a = 1; first order b = (2/3)/(1/4) = 8/3: η(1) = (2/3)/(11/3) = 2/11.
  const PadeLaw first(1, 2. / 3, 1, 0.25);
  CHECK(first.at(1.0, 1.0).xi == about(0.5));
  CHECK(first.at(1.0, 1.0).eta == about(2. / 11));
  // Second order c = 3/4, b = 9/32: ξ(1) = 2/3; η(1) = (2/3)(41/32)/(65/32) = 82/195.
  const PadeLaw second(2, 2. / 3, 1, 0.25);
  CHECK(second.at(1.0, 1.0).xi == about(2. / 3));
  CHECK(second.at(1.0, 1.0).eta == about(82. / 195));
  // u = 2: ξ = 6/7, η = (2/3)(25/16)/(73/16) = 50/219.
  CHECK(second.at(2.0, 1.0).xi == about(6. / 7));
  CHECK(second.at(2.0, 1.0).eta == about(50. / 219));
  const double above = std::nextafter(1.0, 2.0);
  for (const auto& law : {first, second}) {
    CHECK(law.at(above, 1.0).xi == about(law.at(1.0, 1.0).xi));
    CHECK(law.at(above, 1.0).eta == about(law.at(1.0, 1.0).eta));
    const auto a = law.curvature(1.0, 1.0);
    const auto b = law.curvature(above, 1.0);
    CHECK(a.vv == about(b.vv));
    CHECK(a.ss == about(b.ss));
    CHECK(a.vs == about(-std::sqrt(a.vv * a.ss)));
  }
}

TEST_CASE("PadeLaw curvature is the derivative of its forces", "[law][approximations]") {
  for (const int order : {1, 2}) {
    const PadeLaw law(order, 0.6, 1.2, 0.2);
    for (const double u : {0.2, 0.7, 1.4, 6.0}) {
      CAPTURE(order, u);
      // Central differences: the third derivatives are below 100, h²/6 · 100 + ε/h = 2e-9 + 2e-11.
      const double h = 1e-5;
      const auto c = law.curvature(u, 1.0);
      CHECK(std::abs((law.at(u + h, 1).xi - law.at(u - h, 1).xi) / (2 * h) - c.vv) < 2e-9);
      CHECK(std::abs((law.at(u, 1 + h).eta - law.at(u, 1 - h).eta) / (2 * h) - c.ss) < 2e-9);
    }
  }
}

TEST_CASE("TanhLaw: values, limits and potential", "[law][approximations]") {
  const TanhLaw law({1.0, 0.6}, 1e-2);
  CHECK(law.at(0.0, 0.0).xi == 0);
  CHECK(law.at(0.0, 0.0).eta == 0);
  CHECK(law.at(1e-2, 0.0).xi == about(std::tanh(1.0)));
  CHECK(law.at(inf, 1.0).xi == 1);
  CHECK(law.at(largest, largest).eta == 0.6);
  CHECK(law.curvature(0.0, 0.0).vv == about(100));
  CHECK(law.curvature(0.0, 0.0).ss == about(60));
  CHECK(law.curvature(largest, 0.0).vv == 0);
  CHECK(law.potential(0.0, 0.0) == 0);
  CHECK(law.potential(1e-2, 0.0) == about(1e-2 * std::log(std::cosh(1.0))));
  // Small: x²/(2ε) (1 − z²/6); large: x − ε log 2; both sides of the seam at z = 20 alike.
  CHECK(law.potential(1e-8, 0.0) == Approx(0.5e-14).epsilon(1e-12));
  CHECK(law.potential(1e300, 0.0) == 1e300);
  const double seam = 0.2;
  CHECK(law.potential(std::nextafter(seam, 0), 0.0) == about(law.potential(std::nextafter(seam, 1), 0.0)));
  CHECK(law.potential(seam, 0.0) == about(seam - 1e-2 * std::numbers::ln2));
  CHECK(law.potential(0.0, 1e-2) == about(0.6e-2 * std::log(std::cosh(1.0))));
}

TEST_CASE("TanhLaw is the gradient of its potential", "[law][approximations]") {
  const TanhLaw law({1.0, 0.6}, 0.5);
  const double h = 1e-5;  // h²/6 · max|tanh''|/ε² < 1e-10, ε/h = 2e-11
  for (const double v : {0.1, 0.4, 2.0}) {
    for (const double s : {0.2, 1.0}) {
      CHECK(std::abs((law.potential(v + h, s) - law.potential(v - h, s)) / (2 * h) - law.at(v, s).xi) <
            2e-10);
      CHECK(std::abs((law.potential(v, s + h) - law.potential(v, s - h)) / (2 * h) - law.at(v, s).eta) <
            2e-10);
      CHECK(std::abs((law.at(v + h, s).xi - law.at(v - h, s).xi) / (2 * h) - law.curvature(v, s).vv) < 1e-9);
    }
  }
}

TEST_CASE("Approximations stay finite at the edges of the doubles", "[law][approximations]") {
  // Semi-axes far apart: ξ = a² u/b for u << b/a, where a (a/b) = 1e300.
  CHECK(EllipsoidLaw({1e150, 1.0}).at(1e-170, 1.0).xi == about(1e130));
  CHECK(EllipsoidLaw({1e150, 1e-8}).curvature(0.0, 1e100).vv == about(1e208));
  CHECK_THROWS_AS(EllipsoidLaw({1e200, 1e-200}), std::invalid_argument);
  CHECK_THROWS_AS(EllipsoidLaw({1e-200, 1e200}), std::invalid_argument);
  // 1/slope and 1/slope² as doubles.
  for (const int order : {1, 2}) {
    CHECK_THROWS_AS(PadeLaw(order, 1, 1e-310, 1), std::invalid_argument);
    CHECK_THROWS_AS(PadeLaw(order, 1, 1, 1e-310), std::invalid_argument);
    CHECK_THROWS_AS(PadeLaw(order, 1e-310, 1, 1), std::invalid_argument);
    const PadeLaw law(order, 0.6, 1.2, 0.2);
    for (const double x : {smallest, 1e-310}) {
      CHECK(law.curvature(0.0, x).vv == inf);
      CHECK(law.curvature(0.0, x).vs == 0);
      CHECK(law.curvature(x, 0.0).ss == inf);
      CHECK(law.curvature(x, 0.0).vs == 0);
    }
  }
  // v²/(2ε) and 4 e^{−2z}/ε where sinh²(z/2) and 1/cosh² z alone underflow.
  CHECK(TanhLaw({1.0, 0.6}, 1e300).potential(1e10, 0.0) == about(0.5e-280));
  CHECK(TanhLaw({1.0, 0.6}, 0x1p-1000).curvature(370 * 0x1p-1000, 0.0).vv ==
        Approx(4 * std::exp(-740 + 1000 * std::numbers::ln2)).epsilon(1e-12));
}

TEST_CASE("Approximations refuse what they cannot use", "[law][approximations]") {
  for (const double bad : {0.0, -1.0, not_a_number, inf}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(EllipsoidLaw({bad, 1}), std::invalid_argument);
    CHECK_THROWS_AS(EllipsoidLaw({1, bad}), std::invalid_argument);
    CHECK_THROWS_AS(DecoupledLaw({1, bad}), std::invalid_argument);
    CHECK_THROWS_AS(TanhLaw({1, bad}, 1), std::invalid_argument);
    CHECK_THROWS_AS(TanhLaw({1, 1}, bad), std::invalid_argument);
    CHECK_THROWS_AS(PadeLaw(1, bad, 1, 1), std::invalid_argument);
    CHECK_THROWS_AS(PadeLaw(1, 1, bad, 1), std::invalid_argument);
    CHECK_THROWS_AS(PadeLaw(2, 1, 1, bad), std::invalid_argument);
  }
  CHECK_THROWS_AS(PadeLaw(0, 1, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(PadeLaw(3, 1, 1, 1), std::invalid_argument);
  const auto refuses = [](const auto& law) {
    CHECK_THROWS_AS(law.at(0.0, 0.0), std::domain_error);
    CHECK_THROWS_AS(law.at(not_a_number, 1.0), std::domain_error);
    CHECK_THROWS_AS(law.at(1.0, -1.0), std::domain_error);
    CHECK_THROWS_AS(law.at(inf, inf), std::domain_error);
    CHECK_THROWS_AS(law.curvature(0.0, 0.0), std::domain_error);
    CHECK_THROWS_AS(law.curvature(1.0, not_a_number), std::domain_error);
  };
  refuses(EllipsoidLaw({1, 1}));
  refuses(DecoupledLaw({1, 1}));
  refuses(PadeLaw(1, 1, 1, 1));
  refuses(PadeLaw(2, 1, 1, 1));
  CHECK_THROWS_AS(TanhLaw({1, 1}, 1).at(not_a_number, 1), std::domain_error);
  CHECK_THROWS_AS(TanhLaw({1, 1}, 1).at(1, -1), std::domain_error);
  CHECK_THROWS_AS(TanhLaw({1, 1}, 1).potential(not_a_number, 1), std::domain_error);
}
