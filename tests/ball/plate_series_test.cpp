#include "contensou/ball/plate_series.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"

using namespace contensou;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double eps = std::numeric_limits<double>::epsilon();

/// Fractions of the exact elimination, each within two roundings of its double.
void require_coefficients(const std::vector<double>& obtained, const std::vector<double>& expected) {
  REQUIRE(obtained.size() >= expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) {
    INFO("coefficient " << k);
    CHECK(std::abs(obtained[k] - expected[k]) <= 2 * eps * std::abs(expected[k]));
  }
}

}  // namespace

TEST_CASE("plate series: uniform coefficients are the fractions of LG03 (2.18) and go on", "[plate_series]") {
  const PlateSeries plate = plate_series(0, 6);
  require_coefficients(plate.inner,
                       {3.0 / 2, -15.0 / 32, -5.0 / 128, -75.0 / 8192, -3.0 / 1024, -245.0 / 262144});
  require_coefficients(plate.outer, {4.0, -20.0 / 3, 40.0 / 9, -40.0 / 9, -1072.0 / 81, -20720.0 / 243});
  CHECK(std::abs(plate.seam - 8 / (3 * pi)) <= 2 * eps);
  CHECK(std::abs(plate.extent.eta - 2.0 / 3) <= eps);
}

TEST_CASE("plate series: Hertz coefficients are those of LG03 (3.19), but for 729/32768", "[plate_series]") {
  const PlateSeries plate = plate_series(0.5, 8);
  const double s = std::pow(9 * pi / 32, 2);
  // the powers of ξ* cost a rounding each
  const std::vector<double> expected{9.0 / 8, -243.0 / 1024, -729.0 / 32768, -19683.0 / 4194304,
                                     -177147.0 / 134217728};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const double scaled = plate.inner[k] * std::pow(s, static_cast<double>(k + 1));
    CHECK(std::abs(scaled - expected[k]) <= 20 * eps * std::abs(expected[k]));
  }
  CHECK(plate.inner[7] == 0);  // the ξ¹⁶ term vanishes exactly
  require_coefficients(plate.outer, {5.0, -75.0 / 7, 1250.0 / 147, -62500.0 / 3773, -32031250.0 / 343343});
  CHECK(std::abs(plate.seam - 9 * pi / 32) <= 2 * eps);
  CHECK(std::abs(plate.extent.eta - 3 * pi / 16) <= 2 * eps);

  const PlateSeries printed = printed_hertz_plate();
  const PlateSeries corrected = plate_series(0.5, 3);
  CHECK(std::abs(corrected.inner[2] / printed.inner[2] - 81) <= 81 * 10 * eps);
}

TEST_CASE("plate series: exact on the axes", "[plate_series]") {
  for (const PlateSeries& plate : {printed_uniform_plate(), printed_hertz_plate(), plate_series(0, 12),
                                   plate_series(1, 5), plate_series(-0.5, 7)}) {
    CHECK(boundary_eta(plate, 0) == plate.extent.eta);
    CHECK(boundary_eta(plate, 1) == 0);
    CHECK(contains(plate, 0, 0));
    CHECK_FALSE(contains(plate, 1.001, 0));
    CHECK_FALSE(contains(plate, 0, 1.001 * plate.extent.eta));
    CHECK(contains(plate, 0.3, -0.1));  // symmetric in η
  }
}

TEST_CASE("plate series: the border lies on the left side equal to one", "[plate_series]") {
  for (const PlateSeries& plate :
       {printed_uniform_plate(), plate_series(0, 20), plate_series(0.5, 20), plate_series(1, 4)}) {
    for (int i = 1; i < 100; ++i) {
      const double xi = i / 100.0;
      INFO("xi " << xi);
      // η carries half an ulp, the polynomial a few
      CHECK(std::abs(left_side(plate, xi, boundary_eta(plate, xi)) - 1) <= 20 * eps);
    }
  }
}

TEST_CASE("plate series: both sides of the seam", "[plate_series]") {
  const PlateSeries plate = printed_uniform_plate();
  const double above = std::nextafter(plate.seam, 2.0);
  CHECK(boundary_eta(plate, plate.seam) == inner_boundary_eta(plate, plate.seam));
  CHECK(boundary_eta(plate, above) == outer_boundary_eta(plate, above));
  // The plate is not closed there: the outer piece reaches farther.
  CHECK(outer_boundary_eta(plate, plate.seam) > inner_boundary_eta(plate, plate.seam));
}

TEST_CASE("plate series: many terms tend to the exact border on both sides of the seam", "[plate_series]") {
  // Away from the seam the truncated tail is geometric:
  // (ξ/ξ*)^80 < 1e-6 at 0.84 ξ*, times coefficients below 1e-4.
  const PlateSeries uniform = plate_series(0, 40);
  const PlateSeries hertz = plate_series(0.5, 40);
  for (const double u : {0.05, 0.3, 0.7, 1.7, 4.0, 50.0}) {
    INFO("u " << u);
    const auto a = UniformLaw{}.at(u, 1.0);
    CHECK(std::abs(left_side(uniform, a.xi, a.eta) - 1) <= 1e-9);
    const auto b = HertzLaw{}.at(u, 1.0);
    CHECK(std::abs(left_side(hertz, b.xi, b.eta) - 1) <= 1e-9);
  }
}

TEST_CASE("plate series: bad arguments", "[plate_series]") {
  CHECK_THROWS_AS(plate_series(-1, 3), std::invalid_argument);
  CHECK_THROWS_AS(plate_series(101, 3), std::invalid_argument);
  CHECK_THROWS_AS(plate_series(std::nan(""), 3), std::invalid_argument);
  CHECK_THROWS_AS(plate_series(0, 0), std::invalid_argument);
  CHECK_THROWS_AS(plate_series(0, 41), std::invalid_argument);
  CHECK_THROWS_AS(boundary_eta(printed_uniform_plate(), 1.1), std::domain_error);
  CHECK_THROWS_AS(boundary_eta(printed_uniform_plate(), -0.1), std::domain_error);
  CHECK_THROWS_AS(boundary_eta(printed_uniform_plate(), std::nan("")), std::domain_error);
}
