#include "record.hpp"

#include <catch2/catch.hpp>
#include <limits>

namespace {

std::string verdict_of(double error, double bound, bool should_hold) {
  verify::Claim claim;
  claim.error = error;
  claim.bound = bound;
  claim.should_hold = should_hold;
  return verify::verdict(claim);
}

}  // namespace

TEST_CASE("Verdicts on claims", "[verify]") {
  CHECK(verdict_of(1, 2, true) == "holds");
  CHECK(verdict_of(2, 2, true) == "holds");
  CHECK(verdict_of(3, 2, true) == "fails");
  CHECK(verdict_of(3, 2, false) == "fails as known");
  CHECK(verdict_of(1, 2, false) == "holds unexpectedly");
}

TEST_CASE("What is no number neither holds nor fails as known", "[verify]") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const bool should_hold : {true, false}) {
    CHECK(verdict_of(nan, 2, should_hold) == "fails");
    CHECK(verdict_of(inf, 2, should_hold) == "fails");
    CHECK(verdict_of(1, nan, should_hold) == "fails");
    CHECK(verdict_of(1, inf, should_hold) == "fails");
  }
}
