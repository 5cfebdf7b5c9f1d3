#include "contensou/integrate/moreau_adaptive.hpp"

#include <catch2/catch.hpp>

#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

const AnyFriction frictionless{NoFriction{}};
const AnyFriction disk{FrictionDisk{}};

State adaptive_end(const MechanicalSystem& system, const State& start, double t_end, double tolerance,
                   RunReport& report) {
  IntegratorOptions options;
  options.tolerance = tolerance;
  return end_of(system, start, t_end, Method::moreau_adaptive, 1e-4, &report, options);
}

}  // namespace

TEST_CASE("Adaptive Moreau: error like tolerance^2/3, work like tolerance^-1/3", "[integrate][moreau]") {
  const TippeTopAxis top = paper_top();
  const auto check = [&](const State& start, const State& reference) {
    RunReport loose, tight;
    const double coarse = difference(top, adaptive_end(top, start, reference.t, 1e-6, loose), reference);
    const double fine = difference(top, adaptive_end(top, start, reference.t, 1e-9, tight), reference);
    CAPTURE(coarse, fine, loose.steps, tight.steps);
    // 10^(2/3) = 4.6 and 10^(1/3) = 2.15 for each power of ten; less and more for the start from 1e-4 s.
    CHECK(std::log10(coarse / fine) / 3 > 0.55);
    CHECK(std::log10(coarse / fine) / 3 < 0.80);
    CHECK(std::log10(static_cast<double>(tight.steps) / static_cast<double>(loose.steps)) / 3 > 0.25);
    CHECK(std::log10(static_cast<double>(tight.steps) / static_cast<double>(loose.steps)) / 3 < 0.40);
    CHECK(loose.status == RunStatus::finished);
    CHECK(tight.events.empty());
  };
  const State flying = top_in_flight(top);
  check(flying, SmoothReference(top, -1).run(flying, flight_time, 500));
  const State resting = top.start(0.1, 180);
  check(resting, SmoothReference(top, 0, hertz_border).run(resting, slip_time, 500));
}

TEST_CASE("Adaptive Moreau: impacts found, step size lost and recovered", "[integrate][moreau]") {
  // Bounces at t₀ and t₀ + 2εv/g, then t = 1 in the air.
  const Slab slab({"floor", frictionless, 0, 0, 0.5});
  const double v = std::sqrt(2 * Slab::g);
  RunReport report;
  const State end = adaptive_end(slab, Slab::at(1, {0, 0, 0, 0}), 1, 1e-8, report);
  const double t = 1 - 2 * v / Slab::g;
  CHECK(end.q[2] == Approx(v / 4 * t - Slab::g / 2 * t * t).margin(1e-5));
  CHECK(end.u[2] == Approx(v / 4 - Slab::g * t).margin(1e-5));
  REQUIRE(report.events.size() == 4);
  CHECK(report.events[0].t == Approx(v / Slab::g).margin(1e-4));
  CHECK(report.events[2].t == Approx(2 * v / Slab::g).margin(1e-4));
  // Free fall is exact at any step: all the work is at the two impacts.
  CHECK(report.steps + 2 * report.rejected < 200);
}

TEST_CASE("Adaptive Moreau: impacts that accumulate are passed", "[integrate][moreau]") {
  const Slab slab({"floor", frictionless, 0, 0, 0.5});
  const double v = std::sqrt(2 * Slab::g);
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    RunReport report;
    const State end = adaptive_end(slab, Slab::at(1, {0, 0, 0, 0}), 3, tolerance, report);
    CAPTURE(tolerance);
    CHECK(report.status == RunStatus::finished);
    CHECK(end.q[2] == 0);
    CHECK(end.u[2] == 0);
    CHECK(report.events.back().t == Approx(3 * v / Slab::g).margin(0.05));
    CHECK(report.steps + 2 * report.rejected < 3000);
    CHECK(report.dissipated[0].impact == Approx(Slab::m * Slab::g).epsilon(1e-2));
  }
}

TEST_CASE("Adaptive Moreau: rest costs nothing", "[integrate][moreau]") {
  const Slab block({"floor", disk, 0.5}, [](double) { return Eigen::Vector4d(5, 0, 0, 0); });
  RunReport report;
  const State start = Slab::at(0, {0, 0, 0, 0});
  const State end = adaptive_end(block, start, 100, 1e-9, report);
  CHECK(end.q == start.q);
  CHECK(end.u == start.u);
  CHECK(report.steps < 30);
  CHECK(report.rejected == 0);
}

TEST_CASE("Adaptive Moreau: first events of the paper's top beside the event-driven scheme",
          "[integrate][moreau]") {
  const TippeTopAxis top = paper_top();
  const State start = top.start(0.1, 180);
  IntegratorOptions options;
  options.tolerance = 1e-9;
  RunReport reference;
  end_of(top, start, 1.5, Method::event_driven, 1e-4, &reference, options);
  REQUIRE(reference.events.size() == 2);
  for (const double tolerance : {1e-5, 1e-7}) {
    RunReport report;
    adaptive_end(top, start, 1.5, tolerance, report);
    REQUIRE(report.events.size() == 2);
    // Error like tolerance^2/3 s, times what errors grow to on the way (ten times, by the smooth tests), and
    // the time of a step's end.
    CHECK(report.events[0].t == Approx(reference.events[0].t).margin(10 * std::pow(tolerance, 2.0 / 3)));
  }
}

TEST_CASE("Adaptive Moreau: what cannot be stepped over is told", "[integrate][moreau]") {
  const Slab lost({"floor", frictionless},
                  [](double t) { return Eigen::Vector4d(t > 0.55 ? std::nan("") : 0, 0, 0, 0); });
  RunReport report;
  const State end = adaptive_end(lost, Slab::at(9, {0, 0, 0, 0}), 1, 1e-6, report);
  CHECK(report.status == RunStatus::not_finite);
  CHECK(end.t == Approx(0.55));
  CHECK(end.q.allFinite());
  IntegratorOptions few;
  few.max_steps = 4;
  end_of(lost, Slab::at(9, {0, 0, 0, 0}), 1, Method::moreau_adaptive, 1e-4, &report, few);
  CHECK(report.status == RunStatus::step_limit);
  CHECK(report.steps == 4);
}
