#include "contensou/integrate/sampling.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace contensou;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<double> times(double start, double end, double interval) {
  std::vector<double> shown;
  for (SampleClock clock(start, end, interval); clock.next() < infinite; clock.advance())
    shown.push_back(clock.next());
  return shown;
}

}  // namespace

TEST_CASE("SampleClock: start, multiples of the interval, end", "[integrate]") {
  CHECK(times(1, 2, 0.25) == std::vector<double>{1, 1.25, 1.5, 1.75, 2});
  CHECK(times(1, 2, 0.4) == std::vector<double>{1, 1.4, 1 + 2 * 0.4, 2});
  CHECK(times(1, 2, 1) == std::vector<double>{1, 2});
  CHECK(times(1, 2, 7) == std::vector<double>{1, 2});
  CHECK(times(1, 2, infinite) == std::vector<double>{1, 2});
  CHECK(times(2, 2, 0.1) == std::vector<double>{2});
}

TEST_CASE("SampleClock: multiples, not sums; the end once", "[integrate]") {
  const std::vector<double> shown = times(0, 0.3, 0.1);  // 3·0.1 > 0.3
  CHECK(shown == std::vector<double>{0, 0.1, 0.2, 0.3});
  const std::vector<double> many = times(0, 1000, 0.1);
  REQUIRE(many.size() == 10001);
  for (std::size_t k = 0; k < many.size(); ++k) CHECK(many[k] == static_cast<double>(k) * 0.1);
}

TEST_CASE("record_change: what happened between two modes", "[integrate]") {
  constexpr ContactMode all[] = {ContactMode::open, ContactMode::slip, ContactMode::stick};
  const std::vector<EventKind> expected[3][3] = {
      {{}, {EventKind::close}, {EventKind::close, EventKind::stick}},
      {{EventKind::open}, {}, {EventKind::stick}},
      {{EventKind::open}, {EventKind::slip}, {}},
  };
  for (std::size_t before = 0; before < 3; ++before) {
    for (std::size_t after = 0; after < 3; ++after) {
      std::vector<Event> events;
      record_change(0.5, 7, all[before], all[after], events);
      std::vector<EventKind> kinds;
      for (const Event& event : events) {
        kinds.push_back(event.kind);
        CHECK(event.t == 0.5);
        CHECK(event.contact == 7);
      }
      CAPTURE(before, after);
      CHECK(kinds == expected[before][after]);
    }
  }
}
