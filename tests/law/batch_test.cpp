#include "contensou/law/batch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"
#include "doubles.hpp"

using namespace contensou;

namespace {

struct Columns {
  explicit Columns(std::size_t n) : phi(n), xi(n), eta(n) {}
  ReducedBatch spans() { return {phi, xi, eta}; }
  std::vector<double> phi, xi, eta;
};

std::vector<double> many_ratios() {
  std::vector<double> us{0,         smallest, 1e-310,    1e-300, 1e-8, 0.5, 0.75,  std::nextafter(0.75, 1),
                         1 - 1e-16, 1,        1 + 3e-16, 4. / 3, 2,    1e8, 1e300, largest,
                         inf};
  for (double u = 1e-12; u < 1e12; u *= 1.0137) us.push_back(u);
  for (int i = -500; i <= 500; ++i) us.push_back(1 + i * 0x1p-48);
  return us;
}

/// Both promise 4 ulp of the truth, so they differ by 8 at most.
void check_same(const auto& law, void (*batch)(std::span<const double>, ReducedBatch)) {
  const std::vector<double> us = many_ratios();
  Columns out(us.size());
  batch(us, out.spans());
  int failures = 0;
  for (std::size_t i = 0; i < us.size(); ++i) {
    const Reduced r = reduced(law, us[i]);
    const bool good = ulp_distance(out.phi[i], r.phi) <= 8 && ulp_distance(out.xi[i], r.xi) <= 8 &&
                      ulp_distance(out.eta[i], r.eta) <= 8;
    if (!good && ++failures <= 3) {
      CAPTURE(i, us[i], out.phi[i], r.phi, out.xi[i], r.xi, out.eta[i], r.eta);
      CHECK(good);
    }
  }
  CHECK(failures == 0);
}

}  // namespace

TEST_CASE("A batch is the scalar law, row by row", "[law][batch]") {
  check_same(UniformLaw{}, reduced_uniform);
  check_same(HertzLaw{}, reduced_hertz);
}

TEST_CASE("Any length, and no row depends on its neighbours", "[law][batch]") {
  const std::vector<double> us = many_ratios();
  for (const auto batch : {reduced_uniform, reduced_hertz}) {
    Columns all(us.size());
    batch(us, all.spans());
    for (std::size_t length = 0; length <= 17; ++length) {
      Columns part(length);
      batch(std::span(us).first(length), part.spans());
      for (std::size_t i = 0; i < length; ++i) {
        CHECK(ulp_distance(part.phi[i], all.phi[i]) <= 1);
        CHECK(ulp_distance(part.xi[i], all.xi[i]) <= 1);
        CHECK(ulp_distance(part.eta[i], all.eta[i]) <= 1);
      }
    }
  }
}

TEST_CASE("In place: one of the results where u was", "[law][batch]") {
  const std::vector<double> us = many_ratios();
  for (const auto batch : {reduced_uniform, reduced_hertz}) {
    Columns apart(us.size());
    batch(us, apart.spans());
    for (int where = 0; where < 3; ++where) {
      std::vector<double> u = us;
      Columns out(us.size());
      batch(u, {where == 0 ? u : out.phi, where == 1 ? u : out.xi, where == 2 ? u : out.eta});
      CHECK((where == 0 ? u : out.phi) == apart.phi);
      CHECK((where == 1 ? u : out.xi) == apart.xi);
      CHECK((where == 2 ? u : out.eta) == apart.eta);
    }
  }
}

TEST_CASE("NaN and negative ratios spoil their own row only", "[law][batch]") {
  const std::vector<double> us{0.5, not_a_number, 2.0, -1.0, 1.0, -inf, 0.25, -smallest, 3.0};
  for (const auto batch : {reduced_uniform, reduced_hertz}) {
    Columns out(us.size());
    batch(us, out.spans());
    for (std::size_t i = 0; i < us.size(); ++i) {
      CAPTURE(i);
      CHECK(std::isnan(out.phi[i]) == !(us[i] >= 0));
      CHECK(std::isnan(out.xi[i]) == !(us[i] >= 0));
      CHECK(std::isnan(out.eta[i]) == !(us[i] >= 0));
    }
  }
}

TEST_CASE("Columns of different lengths are refused", "[law][batch]") {
  const std::vector<double> us(5, 1.0);
  for (const auto batch : {reduced_uniform, reduced_hertz}) {
    Columns out(5);
    Columns longer(6);
    CHECK_THROWS_AS(batch(us, {longer.phi, out.xi, out.eta}), std::invalid_argument);
    CHECK_THROWS_AS(batch(us, {out.phi, longer.xi, out.eta}), std::invalid_argument);
    CHECK_THROWS_AS(batch(us, {out.phi, out.xi, longer.eta}), std::invalid_argument);
    CHECK_THROWS_AS(batch({}, out.spans()), std::invalid_argument);
  }
}
