// The result does not depend on how many threads share the work; steps allocate nothing.

#include <catch2/catch.hpp>

#include "../allocation_counter.hpp"
#include "balls.hpp"
#include "contensou/granular/nscd_step.hpp"

using namespace contensou;

namespace {

/// Balls of two kinds and rules in a box, enough for a colour to be shared.
BodiesData crowd(int side) {
  BodiesData data = balls::scene(FrictionDisk{}, 0.3, 0.2);
  data.rules.push_back({"drill", FrictionBall(SmoothPlate(UniformLaw{})), 0.2, 1e-3, 0});
  data.rule.resize(3, 3);
  data.rule << 0, 0, 1, 0, BodiesData::no_rule, 1, 1, 1, 1;
  balls::add_plane(data, {0, 0, 1}, 0);
  for (int i = 0; i < side * side * 3; ++i) {
    const double x = 0.0208 * (i % side), y = 0.0205 * (i / side % side);
    BodyData& ball =
        balls::add_ball(data, 0.01, 0.01, {x + 1e-4 * (i % 7), y, 0.0101 + 0.0203 * (i / side / side)});
    ball.velocity = {0.01 * (i % 5), 0.02 * (i % 3), -0.1};
    ball.spin = {0, 3.0 * (i % 4), 5};
    if (i % 3 == 0) ball.spheres[0].surface = 2;
  }
  return data;
}

State run(const BodiesData& data, double t, int threads) {
  const BodyLayout layout(data);
  State state = layout.start();
  IntegratorOptions options;
  options.step = 1e-3;
  options.solver_tolerance = 1e-6;
  const RunReport report = run_nscd(data, state, t, options, threads);
  CHECK(report.status == RunStatus::finished);
  return state;
}

}  // namespace

TEST_CASE("nscd: the same to the last bit for any number of threads", "[granular]") {
  const BodiesData data = crowd(14);
  const State one = run(data, 0.02, 1);
  for (const int threads : {2, 3}) {
    const State more = run(data, 0.02, threads);
    CHECK((more.q.array() == one.q.array()).all());
    CHECK((more.u.array() == one.u.array()).all());
  }
}

TEST_CASE("nscd: steps allocate nothing once they have met the like", "[granular]") {
  if (!allocation_counter::available()) {
    WARN("not counted: this is another C library, or a sanitizer");
    return;
  }
  const BodiesData data = crowd(4);
  const BodyLayout layout(data);
  IntegratorOptions options;
  options.solver_tolerance = 1e-4;
  RunReport report;
  NscdCounts counts;
  WorkerTeam team(1);
  NscdStep step(layout, options, team, report, counts);
  allocation_counter::reset();
  // The same steps twice.
  for (const bool second : {false, true}) {
    State state = layout.start();
    for (int k = 0; k < 60; ++k) {
      if (second) allocation_counter::start();
      step.advance(state, 1e-3);
      allocation_counter::stop();
    }
  }
  CHECK(counts.contacts > 0);
  CHECK(allocation_counter::count() == 0);
}
