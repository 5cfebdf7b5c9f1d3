#include "contensou/law/power.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "contensou/law/power_limits.hpp"
#include "doubles.hpp"

using namespace contensou;

TEST_CASE("Compiled and by quadrature, the power law is one", "[law][power]") {
  for (const double n : {-0.9, -0.5, 0.0, 0.5, 1.0, 3.3, 100.0}) {
    const PowerQuadrature slow(n);
    const PowerLaw fast(slow);
    CHECK(slow.n() == n);
    CHECK(fast.error_bound() <= 1e-13);
    for (double u = 1e-3; u < 1e3; u *= 2.31) {
      CAPTURE(n, u);
      CHECK(fast.at(u, 1).xi == Approx(slow.at(u, 1).xi).epsilon(1e-13));
      CHECK(fast.at(u, 1).eta == Approx(slow.at(u, 1).eta).epsilon(1e-13));
    }
  }
}

TEST_CASE("The ends of the power law are those of the family", "[law][power]") {
  for (const double n : {-0.99, -0.5, 0.0, 0.5, 1.0, 7.0, 1000.0, 1e6}) {
    CAPTURE(n);
    const PowerLimits limits = power_limits(n);
    const PowerLaw law(n);
    CHECK(law.extent().xi == 1);
    CHECK(law.extent().eta == Approx(limits.eta_max).epsilon(1e-13));
    CHECK(law.at(0, 1).eta == Approx(limits.eta_max).epsilon(1e-13));
    // Small enough for the next term, relative n u², to be gone even at n = 1e6.
    CHECK(law.at(1e-20, 1).xi == Approx(limits.slope * 1e-20).epsilon(1e-13));
    CHECK(law.at(1, 1e-20).eta == Approx(limits.tail * 1e-20).epsilon(1e-13));
    CHECK(law.curvature(0, 1).vv == Approx(limits.slope).epsilon(1e-13));
    CHECK(law.curvature(1, 0).ss == Approx(limits.tail).epsilon(1e-13));
    CHECK(law.at(1, 0).xi == Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("At u = 1 the hypergeometric series have Gauss's sums", "[law][power]") {
  for (const double n : {-0.99, -0.9, -0.5, -0.25, 0.0, 0.5, 1.0, 3.3, 100.0, 1e6}) {
    CAPTURE(n);
    // ξ = f''(0) Γ(n+2)/(Γ(3/2) Γ(n+5/2)) and A = Γ(3/2) Γ(n+2)/Γ(n+5/2), with Γ(3/2)² = π/4; η = ξ/(2n+3),
    // and f'' = ξ/(2n+2), which for n near −1 is far from its values one ulp beside u = 1.
    const PowerLimits limits = power_limits(n);
    const double xi = 4 / std::numbers::pi * limits.eta_max * limits.slope;
    const PowerLaw law(n);
    CHECK(law.at(1, 1).xi == Approx(xi).epsilon(1e-13));
    CHECK(law.at(1, 1).eta == Approx(xi / (2 * n + 3)).epsilon(1e-13));
    CHECK(law.curvature(1, 1).vv == Approx(xi / (2 * n + 2)).epsilon(1e-13));
  }
}

TEST_CASE("A power law stays within its semi-axes", "[law][power]") {
  for (const double n : {-0.9999999, -0.9999, 0.5, 3.0, 17.0, 999.5, 999999.9}) {
    const PowerLaw law(n);
    for (const double small : {0.0, smallest, 1e-300, 1e-18, 1e-12, 1e-10, 1e-8}) {
      CAPTURE(n, small);
      CHECK(law.at(1, small).xi <= 1);
      CHECK(law.at(small, 1).eta <= law.extent().eta);
      CHECK(reduced(law, 1 / small).phi <= 1);
    }
  }
}

TEST_CASE("Exponents that are none are refused", "[law][power]") {
  for (const double n : {-1.0, -3.0, not_a_number, inf, 1.1e6}) {
    CHECK_THROWS_AS(PowerQuadrature(n), std::invalid_argument);
    CHECK_THROWS_AS(PowerLaw(n), std::invalid_argument);
  }
}
