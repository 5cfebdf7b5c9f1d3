// Many bodies where the solver is at its end: what a residual may leave, and that it is told.
#include <catch2/catch.hpp>
#include <string>

#include "balls.hpp"

using namespace contensou;
using balls::add_ball;
using balls::add_plane;

namespace {

const AnyFriction coulomb{FrictionDisk{}};

IntegratorOptions options(double step, double tolerance) {
  IntegratorOptions o;
  o.method = Method::nscd;
  o.step = step;
  o.solver_tolerance = tolerance;
  return o;
}

/// Three balls in a row before a wall, the first one fast, the last one of the mass given.
BodiesData shot(double speed, double last_mass) {
  BodiesData data = balls::scene(coulomb, 0.3, 0);
  data.gravity.setZero();
  add_plane(data, {-1, 0, 0}, -1);
  add_ball(data, 1, 0.01, {0, 0, 0}).velocity = {speed, 0, 0};
  add_ball(data, 1, 0.01, {0.5, 0.001, 0});
  add_ball(data, last_mass, 0.01, {0.7, 0, 0});
  return data;
}

}  // namespace

TEST_CASE("nscd: however fast, nothing passes through a wall or another ball", "[granular]") {
  for (const double last_mass : {0.5, 1e-3, 1e-6}) {
    for (const double speed : {1e1, 1e2, 1e4, 1e6}) {
      CAPTURE(last_mass, speed);
      const BodiesData data = shot(speed, last_mass);
      const BodyLayout layout(data);
      State state = layout.start();
      NscdCounts counts;
      const double step = 1e-3;
      const RunReport report = run_nscd(data, state, 0.01, options(step, 1e-10), 1, {}, &counts);
      CHECK(report.status == RunStatus::finished);
      // A residual ρ leaves γ_N − c >= −ρV, so a gap at the end no less than −ρVΔt; V = max |γ − c| with
      // gaps below 1 m. 1e-9 of rounding and of what mean velocities may leave.
      const double left = report.worst_residual * (speed + 1 / step) * step + 1e-9;
      CHECK(counts.deepest <= left);
      CHECK(state.q[14] <= 0.99 + left);
      // Solved to what was asked for but at 1e6 m/s, 10⁵ radii in a step.
      if (speed < 1e6) {
        CHECK(counts.unsolved == 0);
        CHECK(counts.deepest < 1e-9);
      }
    }
  }
}

TEST_CASE("nscd: inclusions that are not solved are told in one line", "[granular]") {
  BodiesData data = balls::scene(coulomb, 0.3, 0);
  add_plane(data, {0, 0, 1}, 0);
  for (int i = 0; i < 4; ++i) add_ball(data, 1, 0.01, {0.0199 * i, 0, 0.011 + 0.01 * (i % 2)});
  const BodyLayout layout(data);
  State state = layout.start();
  CHECK(run_nscd(data, state, 0.1, options(1e-3, 1e-6), 1).message.empty());
  state = layout.start();
  NscdCounts counts;  // no double reaches this residual where balls hold each other
  const RunReport report = run_nscd(data, state, 0.1, options(1e-3, 1e-30), 1, {}, &counts);
  CHECK(report.status == RunStatus::finished);
  REQUIRE(counts.unsolved > 0);
  CHECK(report.message.find(std::to_string(counts.unsolved) + " of 100 steps: contacts not solved to 1e-30, "
                                                              "worst residual ") == 0);
  CHECK(report.message.find('\n') == std::string::npos);
}
