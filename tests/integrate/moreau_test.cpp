#include "contensou/integrate/moreau.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr auto second = Method::moreau;
constexpr auto implicit = Method::moreau_implicit;
const AnyFriction frictionless{NoFriction{}};
const AnyFriction disk{FrictionDisk{}};

/// The order between steps of h and h/2 lies within 0.1 of what it should be.
void check_order(const MechanicalSystem& system, const State& start, const State& reference, double h,
                 Method method, double expected) {
  const double coarse = difference(system, end_of(system, start, reference.t, method, h), reference);
  const double fine = difference(system, end_of(system, start, reference.t, method, h / 2), reference);
  CAPTURE(name(method), coarse, fine);
  CHECK(std::log2(coarse / fine) > expected - 0.1);
  CHECK(std::log2(coarse / fine) < expected + 0.1);
}

void check_orders(const MechanicalSystem& system, const State& start, const State& reference, double h) {
  check_order(system, start, reference, h, second, 2);
  check_order(system, start, reference, h, implicit, 1);
}

/// A ball dropped from z: its height and velocity at t, by its bounces with ε.
State bouncing_ball(double z, double restitution, double t) {
  double v = std::sqrt(2 * Slab::g * z);
  double landing = v / Slab::g;
  if (t < landing) return Slab::at(z - Slab::g / 2 * t * t, {0, 0, -Slab::g * t, 0});
  for (v *= restitution; landing + 2 * v / Slab::g < t; v *= restitution) landing += 2 * v / Slab::g;
  t -= landing;
  return Slab::at(v * t - Slab::g / 2 * t * t, {0, 0, v - Slab::g * t, 0});
}

}  // namespace

TEST_CASE("Moreau: orders in free flight, slip and rolling", "[integrate][moreau]") {
  const TippeTopAxis top = paper_top();
  const State flying = top_in_flight(top);
  check_orders(top, flying, SmoothReference(top, -1).run(flying, flight_time, 500), 1e-4);
  const State resting = top.start(0.1, 180);
  check_orders(top, resting, SmoothReference(top, 0, hertz_border).run(resting, slip_time, 500), 1e-4);

  const TippeTopAxis roller = rolling_top();
  const State rolling = top_rolling(roller);
  SmoothReference reference(roller, 0);
  for (int k = 1; k <= 20; ++k) {  // the reference is one: nothing slips or opens
    reference.run(rolling, rolling_time * k / 20, 20 * k);
    const Eigen::Vector3d force = reference.rolling_force();
    REQUIRE(force.tail<2>().norm() < roller.contacts()[0].mu * force[0]);
  }
  check_orders(roller, rolling, reference.run(rolling, rolling_time, 1000), 2e-4);
}

TEST_CASE("Moreau: forces of time alone are felt when they are there", "[integrate][moreau]") {
  // F_z/m = g + 6t: SDIRK2 integrates linear forces exactly for u; rounding of a hundred steps.
  const Slab slab({"floor", frictionless},
                  [](double t) { return Eigen::Vector4d(0, 0, Slab::m * (Slab::g + 6 * t), 0); });
  CHECK(end_of(slab, Slab::at(1, {0, 0, 0, 0}), 1, second, 0.01).u[2] == Approx(3).epsilon(1e-13));
  // Backward Euler: ½Δt late.
  CHECK(end_of(slab, Slab::at(1, {0, 0, 0, 0}), 1, implicit, 0.01).u[2] == Approx(3.03).epsilon(1e-13));
}

TEST_CASE("Moreau: the constraint does not drift", "[integrate][moreau]") {
  const TippeTopAxis top = paper_top();
  for (const Method method : {second, implicit}) {
    State state = top.start(0.1, 180);
    IntegratorOptions options;
    options.method = method;
    options.step = options.output_interval = 5e-4;
    double deepest = 0;
    const RunReport report = integrate(top, state, 1, options, [&](const Sample& s) {
      if (s.modes[0] != ContactMode::open) deepest = std::max(deepest, std::abs(top.gap(0, s.t, s.q)));
    });
    CHECK(report.status == RunStatus::finished);
    CHECK(report.events.empty());
    CHECK(deepest < 1e-14 * top.length_scale());
  }
}

TEST_CASE("Moreau: inelastic stays inelastic", "[integrate][moreau]") {
  const Slab slab({"floor", frictionless});
  for (const Method method : {second, implicit}) {
    for (const double z : {0.1, 0.1003, 0.1007}) {
      State state = Slab::at(z, {0, 0, 0, 0});
      IntegratorOptions options;
      options.method = method;
      options.step = options.output_interval = 1e-3;
      const double landing = std::sqrt(2 * z / Slab::g);
      double highest = 0;
      const RunReport report = integrate(slab, state, 1, options, [&](const Sample& s) {
        if (s.t > landing + 2e-3) highest = std::max({highest, std::abs(s.q[2]), std::abs(s.u[2])});
      });
      CAPTURE(name(method), z);
      CHECK(highest < 1e-17);
      REQUIRE(report.events.size() == 1);
      CHECK(report.events[0].kind == EventKind::close);
      // At the end of the step; backward Euler falls by ½gΔt t too far before.
      CHECK(report.events[0].t > landing - 1e-3);
      CHECK(report.events[0].t < landing + 1e-3);
    }
  }
}

TEST_CASE("Moreau: bounces, of order two and one, come to an end", "[integrate][moreau]") {
  constexpr double restitution = 0.5;
  const Slab slab({"floor", frictionless, 0, 0, restitution});
  // Worst of several phases of the impacts within their steps.
  const auto worst = [&](Method method, double h) {
    double error = 0;
    for (int k = 0; k < 10; ++k) {
      const double z = 1 + 0.001 * k;
      const State exact = bouncing_ball(z, restitution, 1);
      const State end = end_of(slab, Slab::at(z, {0, 0, 0, 0}), 1, method, h);
      error = std::max({error, std::abs(end.q[2] - exact.q[2]), std::abs(end.u[2] - exact.u[2])});
    }
    return error;
  };
  const double two = std::log2(worst(second, 8e-4) / worst(second, 2e-4)) / 2;
  CHECK(two > 1.75);
  CHECK(two < 2.25);
  const double one = std::log2(worst(implicit, 8e-4) / worst(implicit, 2e-4)) / 2;
  CHECK(one > 0.9);
  CHECK(one < 1.1);

  for (const Method method : {second, implicit}) {
    RunReport report;
    const double h = 1e-3;
    const State end = end_of(slab, Slab::at(1, {0, 0, 0, 0}), 2, method, h, &report);
    CHECK(end.q[2] == 0);
    CHECK(end.u[2] == 0);
    // v/g (1 + 2ε + 2ε² + …) = 3v/g, less the bounces that are shorter than two steps: 2hε/(1 − ε) and the
    // like.
    const double v = std::sqrt(2 * Slab::g);
    CHECK(report.events.back().t == Approx(3 * v / Slab::g).margin(method == second ? 4 * h : 30 * h));
    CHECK(report.events.size() % 2 == 1);
    CHECK(report.dissipated[0].total() == report.dissipated[0].impact);
  }
  RunReport report;
  end_of(slab, Slab::at(1, {0, 0, 0, 0}), 2, second, 1e-3, &report);
  CHECK(report.dissipated[0].impact == Approx(Slab::m * Slab::g).epsilon(1e-3));
}

TEST_CASE("Moreau: an approach on the floor is an impact at once", "[integrate][moreau]") {
  for (const double restitution : {0.0, 0.5}) {
    const Slab slab({"floor", frictionless, 0, 0, restitution});
    for (const Method method : {second, implicit}) {
      RunReport report;
      const double h = 1e-3;
      const State end = end_of(slab, Slab::at(0, {0, 0, -4, 0}), h, method, h, &report);
      CHECK(end.u[2] == Approx(restitution == 0 ? 0 : 2 - Slab::g * h).margin(1e-15));
      REQUIRE(!report.events.empty());
      CHECK(report.events[0].kind == EventKind::close);
      CHECK(report.events[0].t == 0);
      // ½m(v² − ε²v²).
      CHECK(report.dissipated[0].impact == Approx(16 * (1 - restitution * restitution)).epsilon(1e-14));
    }
  }
}

TEST_CASE("Moreau: what is shown inside a step does not cut the floor", "[integrate][moreau]") {
  const Slab slab({"floor", frictionless, 0, 0, 0.5});
  State state = Slab::at(1, {0, 0, 0, 0});
  IntegratorOptions options;
  options.method = second;
  options.step = 1e-2;
  options.output_interval = 1e-3;
  const double v = std::sqrt(2 * Slab::g);
  const RunReport report = integrate(slab, state, 0.9 * 2 * v / Slab::g, options, [&](const Sample& s) {
    const State exact = bouncing_ball(1, 0.5, s.t);
    // Linear in the step of the landing, ⅛gΔt² off, and times of landing by ⅛gΔt²/v: less than gΔt² in all.
    CAPTURE(s.t);
    CHECK(s.q[2] > -Slab::g * 1e-4);
    CHECK(std::abs(s.q[2] - exact.q[2]) < Slab::g * 1e-4);
  });
  CHECK(report.status == RunStatus::finished);
}

TEST_CASE("Moreau: nothing creeps, nothing rings", "[integrate][moreau]") {
  const Slab block({"floor", disk, 0.5}, [](double) { return Eigen::Vector4d(5, 0, 0, 0); });
  const Slab free({"floor", disk, 0.5});
  for (const Method method : {second, implicit}) {
    CAPTURE(name(method));
    const State start = Slab::at(0, {0, 0, 0, 0});
    RunReport report;
    const State end = end_of(block, start, 1, method, 1e-3, &report);
    CHECK(end.q == start.q);
    CHECK(end.u == start.u);
    CHECK(report.events.empty());

    // 1.03 m/s, −5 m/s²: stops at 0.206 s, and once and for all.
    State state = Slab::at(0, {1.03, 0, 0, 0});
    IntegratorOptions options;
    options.method = method;
    options.step = options.output_interval = 1e-3;
    double least = 1;
    double after = 0;
    report = integrate(free, state, 1, options, [&](const Sample& s) {
      least = std::min(least, s.u[0]);
      if (s.t > 0.2061 + 1e-3) after = std::max(after, std::abs(s.u[0]));
    });
    CHECK(least > -1e-15);
    CHECK(after < 1e-15);
    REQUIRE(report.events.size() == 1);
    CHECK(report.events[0].kind == EventKind::stick);
    CHECK(report.events[0].t == Approx(0.206).margin(1e-3));
    // v²/(2·5), exact but for the last step, or ½Δt too early.
    CHECK(state.q[0] == Approx(0.10609).margin(method == second ? 5e-6 : 6e-4));
    CHECK(report.dissipated[0].sliding == Approx(1.03 * 1.03).epsilon(1e-12));
    CHECK(report.dissipated[0].impact == 0);
  }
}

TEST_CASE("Moreau: a push over the limit slides", "[integrate][moreau]") {
  const Slab block({"floor", disk, 0.5}, [](double) { return Eigen::Vector4d(20, 0, 0, 0); });
  RunReport report;
  const State end = end_of(block, Slab::at(0, {0, 0, 0, 0}), 1, second, 1e-3, &report);
  // ½ 5 t²; the first step is one of backward Euler, ½aΔt² = 2.5e-6 too far.
  CHECK(end.q[0] == Approx(2.5).margin(2.6e-6));
  CHECK(end.u[0] == Approx(5).epsilon(1e-12));
  REQUIRE(report.events.size() == 1);
  CHECK(report.events[0].kind == EventKind::slip);
}

TEST_CASE("Moreau: nutation is kept by the one and deadened by the other", "[integrate][moreau]") {
  const TippeTopAxis top = paper_top();
  const State start = top_in_flight(top);
  const auto across = [&](const State& s) { return top.spin(s.q, s.u).cross(top.axis(s.q)).norm(); };
  // Across the axis ω turns about L with L/I₁.
  const TippeTopData& d = top.data();
  const Eigen::Vector3d e = top.axis(start.q), w = top.spin(start.q, start.u);
  const double rate = (d.i1 * (w - w.dot(e) * e) + d.i3 * w.dot(e) * e).norm() / d.i1;
  const double h = 2e-4;
  const double damped = across(end_of(top, start, flight_time, implicit, h)) / across(start);
  const double expected = std::pow(1 + rate * rate * h * h, -flight_time / h / 2);
  CHECK(expected < 0.9);
  // Linear in the amplitude, which is a tenth of the spin: squares of it are left out.
  CHECK(damped == Approx(expected).epsilon(0.01));
  const double kept = across(end_of(top, start, flight_time, second, h)) / across(start);
  CHECK(kept == Approx(1).margin(1e-4));
}

TEST_CASE("Moreau: the paper's top, energy balanced", "[integrate][moreau]") {
  const TippeTopAxis top = paper_top();
  const State start = top.start(0.1, 180);
  const auto defect = [&](double h) {
    RunReport report;
    const State end = end_of(top, start, 1, second, h, &report);
    const auto energy = [&](const State& s) {
      return top.kinetic_energy(s.q, s.u) + top.potential_energy(s.q);
    };
    return std::abs(energy(end) + report.dissipated[0].total() - energy(start)) / energy(start);
  };
  const double order = std::log2(defect(1e-3) / defect(5e-4));
  CHECK(order > 1.7);  // smooth all the time
  CHECK(order < 3.3);
}

TEST_CASE("Moreau: steps that are too long and numbers that end are told", "[integrate][moreau]") {
  const TippeTopAxis top = paper_top();
  RunReport report;
  const State end = end_of(top, top.start(0.1, 180), 1, implicit, 0.05, &report);
  CHECK(report.status == RunStatus::solver_failed);
  CHECK(report.message.find("too long") != std::string::npos);
  CHECK(report.message.find("t = 0 s") != std::string::npos);
  CHECK(end.q.allFinite());
  for (const Method method : {second, implicit}) {
    const Slab lost({"floor", frictionless},
                    [](double t) { return Eigen::Vector4d(t > 0.55 ? std::nan("") : 0, 0, 0, 0); });
    const State last = end_of(lost, Slab::at(9, {0, 0, 0, 0}), 1, method, 0.1, &report);
    CHECK(report.status == RunStatus::not_finite);
    CHECK(last.q.allFinite());
    CHECK(last.t == Approx(0.5));
    IntegratorOptions few;
    few.max_steps = 3;
    const Slab slab({"floor", frictionless});
    CHECK(end_of(slab, Slab::at(9, {0, 0, 0, 0}), 1, method, 0.1, &report, few).t == Approx(0.3));
    CHECK(report.status == RunStatus::step_limit);
  }
}
