// The run from event to event on the top: orders, agreement of formulations and laws, two contacts, and that
// nothing is allocated in a step.

#include <catch2/catch.hpp>

#include "../allocation_counter.hpp"
#include "contensou/integrate/hybrid_run.hpp"
#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr Method both[] = {Method::rk4, Method::event_driven};

State run(const MechanicalSystem& system, const State& start, double t_end, double tolerance,
          RunReport& report) {
  IntegratorOptions options;
  options.tolerance = tolerance;
  State state = start;
  report = integrate(system, state, t_end, options);
  CHECK(report.status == RunStatus::finished);
  CHECK(report.message.empty());
  return state;
}

void check_order_4(const MechanicalSystem& system, const State& start, const State& reference, double h) {
  const double coarse = difference(system, end_of(system, start, reference.t, Method::rk4, h), reference);
  const double fine = difference(system, end_of(system, start, reference.t, Method::rk4, h / 2), reference);
  CAPTURE(coarse, fine);
  CHECK(std::log2(coarse / fine) > 3.8);
  CHECK(std::log2(coarse / fine) < 4.2);
}

/// The inclination at which both contacts touch the floor.
double lying_flat(const TippeTopData& top) { return std::acos((top.r1 - top.r2) / (top.a1 - top.a2)); }

void check_same_events(const RunReport& a, const RunReport& b, double time) {
  REQUIRE(a.events.size() == b.events.size());
  for (std::size_t k = 0; k < a.events.size(); ++k) {
    CAPTURE(k, name(a.events[k].kind), name(b.events[k].kind), a.events[k].t - b.events[k].t);
    CHECK(a.events[k].kind == b.events[k].kind);
    CHECK(a.events[k].contact == b.events[k].contact);
    CHECK(std::abs(a.events[k].t - b.events[k].t) <= time);
  }
}

}  // namespace

TEST_CASE("Event to event: RK4 has order 4 in flight, slip and rolling", "[integrate][hybrid]") {
  const TippeTopAxis top = paper_top();
  const State flying = top_in_flight(top);
  check_order_4(top, flying, SmoothReference(top, -1).run(flying, flight_time, 500), 2e-4);
  const State resting = top.start(0.1, 180);
  check_order_4(top, resting, SmoothReference(top, 0, hertz_border).run(resting, slip_time, 500), 2e-4);
  const TippeTopAxis roller = rolling_top();
  const State rolling = top_rolling(roller);
  check_order_4(roller, rolling, SmoothReference(roller, 0).run(rolling, rolling_time, 1000), 2e-3);
}

TEST_CASE("Event to event: the reference in slip is reproduced within a few tolerances",
          "[integrate][hybrid]") {
  const TippeTopAxis top = paper_top();
  const State resting = top.start(0.1, 180);
  const State reference = SmoothReference(top, 0, hertz_border).run(resting, slip_time, 500);
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    RunReport report;
    const State end = run(top, resting, slip_time, tolerance, report);
    CAPTURE(tolerance, report.steps);
    CHECK(report.events.empty());
    CHECK(difference(top, end, reference) < 100 * tolerance);
  }
}

TEST_CASE("Event to event: events of the paper's top do not depend on tolerance or coordinates",
          "[integrate][hybrid]") {
  const TippeTopAxis axis = paper_top();
  const TippeTopEuler euler(TippeTopData{}, tippe_top_contacts(system_test::hertz));
  constexpr double t_end = 2.2;  // over the first landing of the tip
  RunReport loose, tight, other;
  run(axis, axis.start(0.1, 180), t_end, 1e-9, loose);
  const State end = run(axis, axis.start(0.1, 180), t_end, 1e-12, tight);
  const State euler_end = run(euler, euler.start(0.1, 180), t_end, 1e-11, other);
  REQUIRE(tight.events.size() > 1);
  check_same_events(loose, tight, 1e-6);
  check_same_events(other, tight, 1e-8);
  CHECK(std::abs(euler.inclination(euler_end.q) - axis.inclination(end.q)) < 1e-7);
  CHECK(std::abs(euler.height(euler_end.q) - axis.height(end.q)) < 1e-9);
}

TEST_CASE("Event to event: a small patch behaves like a point", "[integrate][hybrid]") {
  const TippeTopAxis point(TippeTopData{}, tippe_top_contacts(system_test::point));
  RunReport report;
  const State start = point.start(0.3, 40, 0.0125);
  const State expected = run(point, start, 0.3, 1e-10, report);
  const auto distance = [&](double radius) {
    const TippeTopAxis patch(TippeTopData{}, tippe_top_contacts(system_test::hertz, 0.3, radius));
    RunReport other;
    const double d = difference(point, run(patch, start, 0.3, 1e-10, other), expected);
    CHECK(!other.events.empty());
    return d;
  };
  const double large = distance(1e-5), small = distance(1e-9);
  CAPTURE(large, small);
  // O(R): the patch of 1e-9 m differs ten thousand times less than that of 1e-5 m, or by the tolerance.
  CHECK(large < 0.1);
  CHECK(small < 1e-3 * large + 1e-8);
}

TEST_CASE("Event to event: without friction, with mu = 0 and none at all", "[integrate][hybrid]") {
  const AnyFriction none{NoFriction{}};
  const TippeTopAxis smooth(TippeTopData{}, tippe_top_contacts(none));
  const TippeTopAxis zero(TippeTopData{}, tippe_top_contacts(system_test::hertz, 0));
  const State start = smooth.start(0.7, 30, 0.016);
  RunReport a, b;
  const State end = run(smooth, start, 0.3, 1e-11, a);
  const State same = run(zero, start, 0.3, 1e-11, b);
  CHECK(end.q == same.q);
  CHECK(end.u == same.u);
  REQUIRE(!a.events.empty());
  check_same_events(a, b, 0.0);
  // Conserved: the horizontal momentum, the spin about the axis, and the energy but for the impacts.
  CHECK(end.u.head<2>().norm() < 1e-12);
  CHECK(end.u.tail<3>().dot(end.q.tail<3>()) == Approx(30).epsilon(1e-9));
  double lost = 0;
  for (const Dissipation& d : a.dissipated) {
    CHECK(d.sliding == 0);
    CHECK(d.drilling == 0);
    CHECK(d.impact >= 0);
    lost += d.impact;
  }
  const auto energy = [&](const State& s) {
    return smooth.kinetic_energy(s.q, s.u) + smooth.potential_energy(s.q);
  };
  CHECK(energy(start) - energy(end) == Approx(lost).margin(1e-10 * energy(start)));
}

TEST_CASE("Event to event: dropped on both contacts", "[integrate][hybrid]") {
  // Nearly flat on body and tip, which it cannot rest on (both lie to the same side of the centre): it
  // bounces on both in turn and rights itself.
  const TippeTopData d;
  const double flat = lying_flat(d);
  for (const double restitution : {0.0, 0.5}) {
    for (const double tilt : {-0.05, 0.05}) {
      const TippeTopAxis top(d, tippe_top_contacts(system_test::hertz, 0.3, 5e-4, restitution));
      const State start = top.start(flat + tilt, 0, 0.03);
      State end = start;
      IntegratorOptions options;
      options.output_interval = 1e-3;
      double deepest = 0;
      const RunReport report = integrate(top, end, 1, options, [&](const Sample& s) {
        deepest = std::min({deepest, top.gap(0, s.t, s.q), top.gap(1, s.t, s.q)});
      });
      CAPTURE(restitution, tilt);
      CHECK(report.status == RunStatus::finished);
      // Between the ends of steps the extension is one order lower: 1e-9^(7/8).
      CHECK(deepest > -1.4e-8 * top.length_scale());
      std::array<bool, 2> closed{};
      for (std::size_t k = 0; k < report.events.size(); ++k) {
        closed[report.events[k].contact] = true;
        if (k > 0) CHECK(report.events[k].t >= report.events[k - 1].t);
      }
      CHECK(closed[0]);
      CHECK(closed[1]);
      const auto energy = [&](const State& s) {
        return top.kinetic_energy(s.q, s.u) + top.potential_energy(s.q);
      };
      double lost = 0;
      for (const Dissipation& part : report.dissipated) lost += part.total();
      CHECK(std::abs(energy(start) - energy(end) - lost) < 1e-7 * energy(start));
    }
  }
}

TEST_CASE("Event to event: dropped on both contacts it comes to lie on both", "[integrate][hybrid]") {
  // The centre of mass between them.
  for (const double restitution : {0.0, 0.5}) {
    for (const double tilt : {-0.05, 0.05}) {
      for (const AnyFriction* friction : {&system_test::point, &system_test::hertz}) {
        const TippeTopAxis top(system_test::flat, tippe_top_contacts(*friction, 0.3, 0.05, restitution));
        RunReport report;
        const State start = top.start(lying_flat(top.data()) + tilt, 0, 1.5);
        const State end = run(top, start, 20, 1e-9, report);
        CAPTURE(restitution, tilt, report.events.size());
        CHECK(std::abs(top.gap(0, 20, end.q)) < 1e-15);
        CHECK(std::abs(top.gap(1, 20, end.q)) < 1e-15);
        for (std::size_t k = 1; k < report.events.size(); ++k)
          CHECK(report.events[k].t >= report.events[k - 1].t);
        double lost = 0;
        for (const Dissipation& part : report.dissipated) lost += part.total();
        const double energy = top.kinetic_energy(end.q, end.u) + top.potential_energy(end.q);
        CHECK(std::abs(top.potential_energy(start.q) - energy - lost) < 1e-7 * lost);
      }
    }
  }
}

TEST_CASE("Event to event: nothing is allocated in a step", "[integrate][hybrid]") {
  if (!allocation_counter::available()) {
    WARN("not counted: this is another C library, or a sanitizer");
    return;
  }
  const auto allocations = [](const MechanicalSystem& system, const State& start, Method method,
                              double t_end) {
    IntegratorOptions options;
    options.method = method;
    options.step = 1e-4;
    options.tolerance = 1e-9;
    State state = start;
    long shown = 0;
    options.output_interval = t_end / 20;
    allocation_counter::reset();
    const RunReport report = integrate(system, state, t_end, options, [&](const Sample&) {
      if (++shown == 11) allocation_counter::start();  // by now all methods were used that will be
      if (shown == 20) allocation_counter::stop();
    });
    allocation_counter::stop();
    CHECK(report.status == RunStatus::finished);
    CHECK(report.events.empty());
    CHECK(shown == 21);
    return allocation_counter::count();
  };
  const TippeTopAxis top = paper_top();
  const TippeTopAxis roller = rolling_top();
  // Both contacts slip: a top that lies on them and turns about the vertical.
  const TippeTopAxis wide(system_test::flat, tippe_top_contacts(system_test::hertz, 0.3, 0.05));
  State lying = wide.start(lying_flat(wide.data()), 0);
  lying.u.tail<3>() << 0, 0, 1;
  // A disc in stick, pushed; and one whose slip is so slow that steps are implicit.
  const Slab held({"floor", system_test::hertz, 0.5, 0.1},
                  [](double) { return Eigen::Vector4d(3, 0, 0, 0); });
  const Slab creeping({"floor", system_test::hertz, 0.5, 1e-7});
  for (const Method method : both) {
    CAPTURE(name(method));
    CHECK(allocations(top, top_in_flight(top), method, flight_time) == 0);
    CHECK(allocations(top, top.start(0.1, 180), method, slip_time) == 0);
    CHECK(allocations(roller, top_rolling(roller), method, rolling_time) == 0);
    CHECK(allocations(wide, lying, method, 0.1) == 0);
    CHECK(allocations(held, Slab::at(0, {0, 0, 0, 0}), method, 0.1) == 0);
    CHECK(allocations(creeping, Slab::at(0, {1, 0, 0, 0}), method, 0.1) == 0);
  }
}

TEST_CASE("Event to event: no landing is missed within a step, however often a contact bounces in it",
          "[integrate][hybrid]") {
  // Bouncing while it spins so fast that a contact may rise, fall through the floor and rise again in a step.
  auto contacts = tippe_top_contacts(AnyFriction(FrictionBall(SmoothPlate(HertzLaw{}))), 0.14242514908435666,
                                     2.9769556514528905e-07, 0.64789561449839561);
  contacts[1].mu = 0.32688772837804353;
  contacts[1].radius = 1.1741464127562441e-07;
  contacts[1].restitution = 0.60660797267168399;
  const TippeTopAxis top({}, contacts);
  State state = top.start(1.7843414774917974, 348.68012105297692);
  state.q[2] += 0.019831104604302267;
  IntegratorOptions options;
  options.tolerance = 1e-10;
  options.output_interval = 1e-3;
  double lowest = 0;
  const RunReport report = integrate(top, state, 1.9, options, [&](const Sample& sample) {
    for (std::size_t i = 0; i < 2; ++i) lowest = std::min(lowest, top.gap(i, sample.t, sample.q));
  });
  CHECK(report.status == RunStatus::finished);
  // The extension between the ends of steps is off by some tolerances.
  CHECK(lowest >= -10 * options.tolerance * top.length_scale());
}
