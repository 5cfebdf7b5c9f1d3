#include "contensou/integrate/impact_series.hpp"

#include <catch2/catch.hpp>
#include <initializer_list>

using namespace contensou;

namespace {

/// Adds impacts, the first at t, with the intervals given.
void add(ImpactSeries& series, double t, std::initializer_list<double> intervals) {
  series.add(t);
  for (const double interval : intervals) series.add(t += interval);
}

}  // namespace

TEST_CASE("ImpactSeries: a bouncing ball's impacts have the limit of their geometric series", "[integrate]") {
  for (const double ratio : {0.01, 0.1, 0.5, 0.9, 0.99}) {
    ImpactSeries series;
    const double start = 3, first = 0.2;
    double t = start, interval = first;
    for (int k = 0; k < 20; ++k) {
      series.add(t);
      t += interval;
      interval *= ratio;
      CAPTURE(ratio, k);
      // Times of size 4 are rounded, and 1/(1 − ratio) of their intervals' error is extrapolated; intervals
      // of a few roundings tell no ratio.
      if (k < 6) CHECK(!series.limit(0));
      if (k >= 6 && interval > 1e-10)
        CHECK(*series.limit(0) ==
              Approx(start + first / (1 - ratio)).margin(1e-14 / ((1 - ratio) * (1 - ratio))));
    }
  }
}

TEST_CASE("ImpactSeries: intervals that alternate as they shrink", "[integrate]") {
  ImpactSeries series;
  add(series, 1, {0.5, 0.1, 0.25, 0.05, 0.125, 0.025});
  CHECK(*series.limit(0) == Approx(1 + 2 * 0.6).epsilon(1e-14));
}

TEST_CASE("ImpactSeries: what does not shrink geometrically has no limit", "[integrate]") {
  const auto none = [](std::initializer_list<double> intervals) {
    ImpactSeries series;
    add(series, 0, intervals);
    return !series.limit(0).has_value();
  };
  CHECK(none({1, 1, 1, 1, 1, 1}));
  CHECK(none({1, 2, 4, 8, 16, 32}));
  CHECK(none({1, 1, 0.5, 0.5, 0.1, 0.1}));     // ratios of 1/2 and 1/5
  CHECK(none({1, 1, 0.5, 0.5, 0.27, 0.27}));   // 8 % from geometric
  CHECK(!none({1, 1, 0.5, 0.5, 0.26, 0.26}));  // 4 %
  CHECK(none({0.5, 0.5, 0.25, 0.25, 0.5, 0.5}));
}

TEST_CASE("ImpactSeries: what is too short to be told apart ends at its last impact", "[integrate]") {
  ImpactSeries series;
  add(series, 1, {0.01, 0.02, 0.01, 0.03, 0.01, 0.02});
  CHECK(!series.limit(0.0999));
  REQUIRE(series.limit(0.1001));
  CHECK(*series.limit(0.1001) == Approx(1.1).epsilon(1e-15));
  series.add(2);  // only the last seven count
  CHECK(!series.limit(0.1001));
  series.clear();
  CHECK(!series.limit(1e9));
}
