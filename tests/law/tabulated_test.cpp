#include "contensou/law/tabulated.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "contensou/law/approximations.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"

using namespace contensou;

namespace {

template <class Law>
double largest_error(const Law& law, const TabulatedLaw& table) {
  double error = 0;
  for (double psi = 0.0005; psi < 1.57; psi += 0.001) {
    const double v = std::sin(psi);
    const double s = std::cos(psi);
    const Friction exact = law.at(v, s);
    const Friction found = table.at(v, s);
    error = std::max({error, std::abs(found.xi - exact.xi), std::abs(found.eta - exact.eta)});
  }
  return error;
}

}  // namespace

TEST_CASE("tabulated law: within the bound it states, which falls as analysis says", "[tabulated]") {
  // Cells at the seam are cells⁻² wide, and ξ is δ² log δ there (uniform: fourth power of the cells) or
  // δ^{5/2} (Hertz: fifth); within half a power.
  const auto check = [](const auto& law, double power) {
    double last = 0;
    for (const int cells : {8, 16, 32, 64}) {
      const TabulatedLaw table(law, cells);
      INFO(cells << " cells");
      CHECK(largest_error(law, table) <= table.error_bound());
      if (last > 0) CHECK(std::abs(std::log2(last / table.error_bound()) - power) <= 0.5);
      last = table.error_bound();
    }
  };
  check(UniformLaw{}, 4);
  check(HertzLaw{}, 5);
}

TEST_CASE("tabulated law: exact on the axes, and Euler's relation holds", "[tabulated]") {
  const TabulatedLaw table(HertzLaw{}, 16);
  CHECK(table.at(0, 2).xi == 0);
  CHECK(table.at(0, 2).eta == HertzLaw{}.extent().eta);
  CHECK(table.at(3, 0).xi == 1);
  CHECK(table.at(3, 0).eta == 0);
  // ∂Φ/∂v = ξ, by central differences of the potential the table has: error h²/6 of a third derivative of
  // order 1.
  const double h = 1e-5;
  for (const double v : {0.2, 0.9, 0.999, 1.001, 1.7, 8.0}) {
    CHECK(std::abs((potential(table, v + h, 1) - potential(table, v - h, 1)) / (2 * h) - table.at(v, 1).xi) <=
          1e-9);
    const Curvature c = table.curvature(v, 1);
    CHECK(std::abs((table.at(v + h, 1).xi - table.at(v - h, 1).xi) / (2 * h) - c.vv) <= 1e-7);
  }
}

TEST_CASE("tabulated law: what is refused", "[tabulated]") {
  CHECK_THROWS_AS(TabulatedLaw(HertzLaw{}, 3), std::invalid_argument);
  CHECK_THROWS_AS(TabulatedLaw(HertzLaw{}, 257), std::invalid_argument);
  CHECK_THROWS_AS(TabulatedLaw(DecoupledLaw({1, 0.5}), 16), std::invalid_argument);
  const TabulatedLaw table(HertzLaw{}, 4);
  CHECK_THROWS_AS(table.at(0, 0), std::domain_error);
  CHECK_THROWS_AS(table.at(-1, 1), std::domain_error);
  CHECK_THROWS_AS(table.curvature(std::nan(""), 1), std::domain_error);
}
