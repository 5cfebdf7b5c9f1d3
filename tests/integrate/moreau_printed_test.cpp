#include "contensou/integrate/moreau_printed.hpp"

#include <catch2/catch.hpp>

#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr auto printed = Method::moreau_printed;
const AnyFriction frictionless{NoFriction{}};

double order_of(const MechanicalSystem& system, const State& start, const State& reference, double h) {
  const double coarse = difference(system, end_of(system, start, reference.t, printed, h), reference);
  const double fine = difference(system, end_of(system, start, reference.t, printed, h / 2), reference);
  return std::log2(coarse / fine);
}

}  // namespace

TEST_CASE("Table 1: first order in free flight and in slip", "[integrate][printed]") {
  const TippeTopAxis top = paper_top();
  const State flying = top_in_flight(top);
  const double flight = order_of(top, flying, SmoothReference(top, -1).run(flying, flight_time, 500), 1e-4);
  CHECK(flight > 0.9);
  CHECK(flight < 1.1);
  const State resting = top.start(0.1, 180);
  const double slip =
      order_of(top, resting, SmoothReference(top, 0, hertz_border).run(resting, slip_time, 500), 1e-4);
  CHECK(slip > 0.9);
  CHECK(slip < 1.1);
}

TEST_CASE("Table 1: a parabola is exact", "[integrate][printed]") {
  const Slab slab({"floor", frictionless});
  const State end = end_of(slab, Slab::at(5, {1, 2, 3, 4}), 0.5, printed, 0.01);
  // z = 5 + 3t − 5t²; fifty steps, each rounded.
  CHECK(end.q[2] == Approx(5.25).epsilon(1e-14));
  CHECK(end.u[2] == Approx(-2).epsilon(1e-14));
  CHECK(end.q[3] == Approx(2).epsilon(1e-14));
}

TEST_CASE("Table 1: whole steps up to the end asked for", "[integrate][printed]") {
  const Slab slab({"floor", frictionless});
  RunReport report;
  const State end = end_of(slab, Slab::at(5, {0, 0, 0, 0}), 0.3, printed, 0.1, &report);
  CHECK(end.t == 0.3);
  CHECK(report.steps == 3);  // though 0.3/0.1 rounds to less than 3
  CHECK(end_of(slab, Slab::at(5, {0, 0, 0, 0}), 0.25, printed, 0.1, &report).t == 0.25);
  CHECK(report.steps == 3);
  CHECK(report.evaluations == 3);
  end_of(slab, Slab::at(5, {0, 0, 0, 0}), 0, printed, 0.1, &report);
  CHECK(report.steps == 0);
}

TEST_CASE("Table 1: a body dropped stays down, in the floor", "[integrate][printed]") {
  const Slab slab({"floor", frictionless});
  for (const double z : {0.1, 0.1003, 0.1007}) {
    const double h = 1e-3;
    RunReport report;
    const State end = end_of(slab, Slab::at(z, {0, 0, 0, 0}), 1, printed, h, &report);
    const double speed = std::sqrt(2 * Slab::g * z) + Slab::g * h;
    CAPTURE(z);
    CHECK(end.q[2] <= 0);
    CHECK(end.q[2] >= -speed * h);
    CHECK(std::abs(end.u[2]) < 1e-14);
    REQUIRE(report.events.size() == 1);
    CHECK(report.events[0].kind == EventKind::close);
    const double lost = slab.potential_energy(Slab::at(z, {}).q) - slab.potential_energy(end.q);
    CHECK(report.dissipated[0].impact == Approx(lost).epsilon(1e-12));
    CHECK(report.dissipated[0].total() == report.dissipated[0].impact);
  }
}

TEST_CASE("Table 1: a block pushed at half the limit of friction does not move at all",
          "[integrate][printed]") {
  const AnyFriction disk{FrictionDisk{}};
  const Slab block({"floor", disk, 0.5}, [](double) { return Eigen::Vector4d(5, 0, 0, 0); });
  const State start = Slab::at(0, {0, 0, 0, 0});
  RunReport report;
  const State end = end_of(block, start, 1, printed, 1e-3, &report);
  CHECK(end.q == start.q);
  CHECK(report.events.empty());
}

TEST_CASE("Table 1: an r that is too large is told, not waited for", "[integrate][printed]") {
  const AnyFriction disk{FrictionDisk{}};
  const Slab block({"floor", disk, 0.5}, [](double) { return Eigen::Vector4d(5, 0, 0, 0); });
  IntegratorOptions options;
  options.r = 5 * Slab::m;  // λ_max(W) = 1/m: at most 2m
  RunReport report;
  end_of(block, Slab::at(0, {0, 0, 0, 0}), 0.01, printed, 1e-3, &report, options);
  CHECK(report.status == RunStatus::finished);
  CHECK(report.message.find("not converged") != std::string::npos);
  CHECK(report.worst_residual > 1e-3);
  options.r = 1.5 * Slab::m;
  end_of(block, Slab::at(0, {0, 0, 0, 0}), 0.01, printed, 1e-3, &report, options);
  CHECK(report.message.empty());
  CHECK(report.worst_residual < 1e-8);
}

TEST_CASE("Table 1: restitution is refused, numbers that end are told", "[integrate][printed]") {
  const Slab bouncing({"floor", frictionless, 0, 0, 0.5});
  CHECK_THROWS_AS(end_of(bouncing, Slab::at(1, {0, 0, 0, 0}), 1, printed, 0.1), std::invalid_argument);
  const Slab lost({"floor", frictionless},
                  [](double t) { return Eigen::Vector4d(t > 0.5 ? std::nan("") : 0, 0, 0, 0); });
  RunReport report;
  const State end = end_of(lost, Slab::at(9, {0, 0, 0, 0}), 1, printed, 0.1, &report);
  CHECK(report.status == RunStatus::not_finite);
  CHECK(end.q.allFinite());
  CHECK(end.t == Approx(0.5));
}

TEST_CASE("Table 1: the motion is shown when asked for", "[integrate][printed]") {
  const Slab slab({"floor", frictionless});
  State state = Slab::at(5, {1, 0, 0, 0});
  IntegratorOptions options;
  options.method = printed;
  options.step = 0.1;
  options.output_interval = 0.07;
  std::vector<double> times;
  const RunReport report = integrate(slab, state, 0.3, options, [&](const Sample& s) {
    times.push_back(s.t);
    CHECK(s.q[0] == Approx(s.t).margin(1e-15));
    CHECK(s.u[2] == Approx(-Slab::g * s.t).margin(1e-14));
    CHECK(std::abs(s.q[2] - (5 - 5 * s.t * s.t)) <= Slab::g / 8 * 0.01 * 1.001);
  });
  CHECK(report.status == RunStatus::finished);
  REQUIRE(times.size() == 6);
  for (std::size_t k = 0; k < 5; ++k) CHECK(times[k] == static_cast<double>(k) * 0.07);
  CHECK(times[5] == 0.3);
}
