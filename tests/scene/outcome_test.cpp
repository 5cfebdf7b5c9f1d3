#include "contensou/scene/outcome.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace contensou;

namespace {

using Kind = MeasureScene::Kind;

/// x = f(t) at t = 0, 1/n, ..., 1.
Outcome curve(int n, const std::function<double(double)>& f) {
  Outcome outcome;
  outcome.contacts = {"floor", "wall"};
  outcome.columns = {"t", "unlike", "x"};
  for (int i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / n;
    outcome.rows.insert(outcome.rows.end(), {t, 7.0, f(t)});
  }
  return outcome;
}

MeasureScene of_x(Kind kind, double value = 0) {
  MeasureScene measure;
  measure.kind = kind;
  measure.column = std::string("x");
  measure.value = value;
  return measure;
}

MeasureScene of_event(Kind kind, const char* event, const char* contact, int occurrence = 1) {
  MeasureScene measure;
  measure.kind = kind;
  measure.event = event;
  measure.contact = contact;
  measure.occurrence = occurrence;
  return measure;
}

}  // namespace

TEST_CASE("Outcome: last, least and greatest value of a column", "[scene]") {
  const Outcome wave = curve(1000, [](double t) { return std::sin(5 * t); });
  CHECK(evaluate(of_x(Kind::final), wave) == std::sin(5.0));
  // at t = π/10 and 3π/10, rows beside it: off by (5 · 0.0005)²/2 at most
  CHECK(evaluate(of_x(Kind::maximum), wave) == Approx(1).margin(3.2e-6));
  CHECK(evaluate(of_x(Kind::minimum), wave) == Approx(-1).margin(3.2e-6));
}

TEST_CASE("Outcome: a crossing is the first, from either side, between rows", "[scene]") {
  const Outcome down = curve(10, [](double t) { return 1 - 2 * t; });
  CHECK(evaluate(of_x(Kind::crossing, 0.37), down) == Approx(0.315).epsilon(1e-14));
  const Outcome wave = curve(1000, [](double t) { return std::sin(10 * t); });
  // 10 t = π/6 first, 5π/6 later; linear between rows: f''h²/8 / f' = 100 · 0.5 · 1e-6/8/8.7
  CHECK(evaluate(of_x(Kind::crossing, 0.5), wave) == Approx(M_PI / 60).margin(8e-7));
  CHECK(std::isnan(evaluate(of_x(Kind::crossing, 1.5), wave)));
  CHECK(evaluate(of_x(Kind::crossing, 1), curve(4, [](double) { return 1.0; })) == 0);
}

TEST_CASE("Outcome: root mean square over time of what is linear between rows", "[scene]") {
  CHECK(evaluate(of_x(Kind::trajectory), curve(3, [](double t) { return 3 * t; })) ==
        Approx(std::sqrt(3.0)).epsilon(1e-14));
  const Outcome a = curve(3, [](double t) { return 3 * t; });
  const Outcome b = curve(3, [](double t) { return 3 * t - 6; });
  CHECK(difference(of_x(Kind::trajectory), a, b) == Approx(6).epsilon(1e-14));
  CHECK(difference(of_x(Kind::trajectory), a, a) == 0);
}

TEST_CASE("Outcome: two runs are compared over the time that both cover", "[scene]") {
  const Outcome whole = curve(10, [](double) { return 1.0; });
  Outcome half = curve(10, [](double) { return 3.0; });
  half.rows.resize(3 * 6);
  half.rows.insert(half.rows.end(), {0.55, 7, 1e9});  // where it ended: no row of the other
  CHECK(difference(of_x(Kind::trajectory), whole, half) == Approx(2).epsilon(1e-14));
  CHECK(difference(of_x(Kind::trajectory), half, whole) == Approx(2).epsilon(1e-14));
}

TEST_CASE("Outcome: events by kind, contact and occurrence", "[scene]") {
  Outcome outcome = curve(1, [](double t) { return t; });
  outcome.report.events = {{0.1, EventKind::close, 1},
                           {0.2, EventKind::close, 0},
                           {0.3, EventKind::open, 0},
                           {0.4, EventKind::close, 0}};
  CHECK(evaluate(of_event(Kind::event, "close", "floor"), outcome) == 0.2);
  CHECK(evaluate(of_event(Kind::event, "close", "floor", 2), outcome) == 0.4);
  CHECK(std::isnan(evaluate(of_event(Kind::event, "close", "floor", 3), outcome)));
  CHECK(std::isnan(evaluate(of_event(Kind::event, "stick", "floor"), outcome)));
  CHECK(evaluate(of_event(Kind::count, "close", "floor"), outcome) == 2);
  CHECK(evaluate(of_event(Kind::count, "spin", "wall"), outcome) == 0);
}

TEST_CASE("Outcome: a difference of what one run lacks is none, of what both lack is zero", "[scene]") {
  Outcome with = curve(1, [](double t) { return t; });
  const Outcome without = with;
  with.report.events = {{0.5, EventKind::slip, 0}};
  const MeasureScene slip = of_event(Kind::event, "slip", "floor");
  CHECK(std::isnan(difference(slip, with, without)));
  CHECK(std::isnan(difference(slip, without, with)));
  CHECK(difference(slip, without, without) == 0);
  CHECK(difference(of_event(Kind::count, "slip", "floor"), with, without) == 1);
}

TEST_CASE("Outcome: a column that is not there is named", "[scene]") {
  MeasureScene measure = of_x(Kind::final);
  measure.column = "height";
  CHECK_THROWS_WITH(evaluate(measure, curve(1, [](double t) { return t; })),
                    Catch::Contains("no column height"));
}
