#include "contensou/integrate/hybrid_run.hpp"

#include <catch2/catch.hpp>

#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/point_mass.hpp"
#include "contensou/system/sliding_disc.hpp"
#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr double g = Slab::g, m = Slab::m;
const AnyFriction frictionless{NoFriction{}};
const AnyFriction disk{FrictionDisk{}};
const AnyFriction& hertz = system_test::hertz;
constexpr Method both[] = {Method::rk4, Method::event_driven};

struct Outcome {
  State state;
  RunReport report;
};

Outcome run(const MechanicalSystem& system, const State& start, double t_end, IntegratorOptions options,
            const Observer& observer = {}) {
  Outcome out{start, {}};
  out.report = integrate(system, out.state, t_end, options, observer);
  return out;
}

Outcome run(const MechanicalSystem& system, const State& start, double t_end, Method method,
            double step = 1e-2) {
  IntegratorOptions options;
  options.method = method;
  options.step = step;
  const Outcome out = run(system, start, t_end, options);
  CHECK(out.report.status == RunStatus::finished);
  CHECK(out.report.message.empty());
  CHECK(out.state.t == t_end);
  for (std::size_t k = 1; k < out.report.events.size(); ++k)
    CHECK(out.report.events[k].t >= out.report.events[k - 1].t);
  return out;
}

std::vector<double> times_of(const RunReport& report, EventKind kind) {
  std::vector<double> times;
  for (const Event& event : report.events) {
    if (event.kind == kind) times.push_back(event.t);
  }
  return times;
}

/// Energy at the start is that at the end and what was dissipated.
double energy_defect(const MechanicalSystem& system, const State& start, const Outcome& out) {
  const auto energy = [&](const State& s) {
    return system.kinetic_energy(s.q, s.u) + system.potential_energy(s.q);
  };
  double defect = energy(start) - energy(out.state);
  for (const Dissipation& d : out.report.dissipated) defect -= d.total();
  return std::abs(defect);
}

}  // namespace

TEST_CASE("Event to event: a block that is held stays where it is", "[integrate][hybrid]") {
  for (const AnyFriction* friction : {&disk, &hertz}) {
    const double torque = friction == &hertz ? 0.1 : 0;
    const Slab slab({"floor", *friction, 0.5, 0.1},
                    [torque](double) { return Eigen::Vector4d(3, -4, 0, torque); });
    for (const Method method : both) {
      const Outcome out = run(slab, Slab::at(0, {0, 0, 0, 0}), 10, method);
      CAPTURE(name(method));
      CHECK(out.report.events.empty());
      CHECK(out.state.u.norm() < 1e-14);
      CHECK(out.state.q.norm() < 1e-13);
      CHECK(out.report.dissipated[0].total() == 0);
    }
  }
}

TEST_CASE("Event to event: a push that grows starts slip when friction is used up", "[integrate][hybrid]") {
  // μmg t along (0.6, 0.8): slip from t = 1 s on, at the acceleration μg(t − 1).
  const Slab slab({"floor", disk, 0.5}, [](double t) -> Eigen::Vector4d {
    return Eigen::Vector4d(0.6, 0.8, 0, 0) * (0.5 * m * g * t);
  });
  for (const Method method : both) {
    const Outcome out = run(slab, Slab::at(0, {0, 0, 0, 0}), 2, method);
    CAPTURE(name(method));
    const std::vector<double> slips = times_of(out.report, EventKind::slip);
    REQUIRE(slips.size() == 1);
    CHECK(out.report.events.size() == 1);
    // The limit is passed by 1e-10 of itself; slip starts at 2·50·tolerance of the speed scale √10 m/s.
    CHECK(slips[0] == Approx(1).epsilon(1.1e-10));
    const double v = 0.5 * g / 2;
    CHECK((out.state.u.head<2>() - v * Eigen::Vector2d(0.6, 0.8)).norm() < 1e-6);
    CHECK(out.report.dissipated[0].sliding == Approx(0.5 * m * g * 0.5 * g / 6).epsilon(1e-6));
  }
}

TEST_CASE("Event to event: dropped without restitution it stays", "[integrate][hybrid]") {
  for (const AnyFriction* friction : {&frictionless, &disk, &hertz}) {
    const Slab slab({"floor", *friction, 0.5, 0.1});
    for (const Method method : both) {
      const Outcome out = run(slab, Slab::at(0.7, {0, 0, 0, 0}), 3, method);
      CAPTURE(name(method));
      REQUIRE(!out.report.events.empty());
      CHECK(out.report.events[0].kind == EventKind::close);
      CHECK(std::abs(out.report.events[0].t - std::sqrt(1.4 / g)) < 1e-14);
      CHECK(out.report.events.size() == (friction == &frictionless ? 1u : 2u));  // and sticks
      CHECK(std::abs(out.state.q[2]) < 1e-15);
      CHECK(out.state.u.norm() < 1e-15);
      CHECK(out.report.dissipated[0].impact == Approx(m * g * 0.7).epsilon(1e-13));
    }
  }
}

TEST_CASE("Event to event: a bouncing ball comes to rest when its series says", "[integrate][hybrid]") {
  for (const double restitution : {0.01, 0.1, 0.5, 0.9, 0.99}) {
    const Slab slab({"floor", disk, 0.5, 0, restitution});
    const double z = 0.05, fall = std::sqrt(2 * z / g);
    const double limit = fall * (1 + restitution) / (1 - restitution);
    for (const Method method : both) {
      const Outcome out = run(slab, Slab::at(z, {0, 0, 0, 0}), limit + 1, method);
      CAPTURE(name(method), restitution, limit);
      const std::vector<double> impacts = times_of(out.report, EventKind::close);
      double t = fall, flight = 2 * restitution * fall;
      for (const double impact : impacts) {
        if (flight < 1e-4) break;
        CHECK(std::abs(impact - t) < 1e-12 / (1 - restitution));
        t += flight;
        flight *= restitution;
      }
      const std::vector<double> ends = times_of(out.report, EventKind::accumulation);
      // A bounce is no longer one below a tenth of 1e-5 s (√tolerance of √(1/g)); few bounces before that
      // show no series.
      if (restitution >= 0.5) REQUIRE(ends.size() == 1);
      CHECK(std::abs((ends.empty() ? impacts.back() : ends[0]) - limit) < 1e-6);
      if (restitution >= 0.5) CHECK(std::abs(ends[0] - limit) < 1e-9 / (1 - restitution));
      CHECK(std::abs(out.state.q[2]) < 1e-15);
      CHECK(out.state.u.norm() < 1e-15);
      CHECK(out.report.dissipated[0].impact == Approx(m * g * z).epsilon(1e-8));
    }
  }
}

TEST_CASE("Event to event: elastic is elastic", "[integrate][hybrid]") {
  const Slab slab({"floor", frictionless, 0, 0, 1});
  const double fall = std::sqrt(2 * 0.45 / g);  // 0.3 s
  for (const Method method : both) {
    const Outcome out = run(slab, Slab::at(0.45, {0, 0, 0, 0}), 6, method);
    CAPTURE(name(method));
    CHECK(times_of(out.report, EventKind::close).size() == 10);
    CHECK(out.state.q[2] == Approx(0.45).epsilon(1e-12));
    CHECK(std::abs(out.state.u[2]) < 1e-11);
    CHECK(times_of(out.report, EventKind::close).back() == Approx(19 * fall).epsilon(1e-13));
  }
}

TEST_CASE("Event to event: a block slides to rest on an incline, or for ever", "[integrate][hybrid]") {
  const double tilt = 0.2;
  for (const double mu : {0.1, 0.4}) {
    const PointMass block({.m = 2, .g = g, .tilt = tilt}, {"floor", disk, mu});
    const State start{0, Eigen::Vector3d::Zero(), Eigen::Vector3d(1, 0, 0)};
    const double slower = g * (mu * std::cos(tilt) - std::sin(tilt));
    for (const Method method : both) {
      const Outcome out = run(block, start, 2, method);
      CAPTURE(name(method), mu);
      if (slower < 0) {
        CHECK(out.report.events.empty());
        CHECK(out.state.u[0] == Approx(1 - 2 * slower).epsilon(1e-12));
        CHECK(out.state.q[0] == Approx(2 - 2 * slower).epsilon(1e-12));
      } else {
        const std::vector<double> sticks = times_of(out.report, EventKind::stick);
        REQUIRE(sticks.size() == 1);
        // What slips slower than 50 tolerances of the speed scale, √g here, is stopped.
        CHECK(sticks[0] == Approx(1 / slower).margin(50e-9 * std::sqrt(g) / slower));
        CHECK(out.state.q[0] == Approx(0.5 / slower).epsilon(1e-9));
        CHECK(out.state.u.norm() < 1e-15);
      }
      CHECK(energy_defect(block, start, out) < 1e-9);
    }
  }
}

TEST_CASE("Event to event: a ball slides until it rolls", "[integrate][hybrid]") {
  // Point contact: v = v₀ − μgt, rolls at t = 2v₀/(7μg) with 5/7 v₀.
  const BallOnPlane ball({.m = 1, .r = 0.5, .g = g}, {"floor", disk, 0.2});
  const State start{0, Eigen::Vector3d(0, 0, 0.5), Eigen::VectorXd{{1.2, 1.6, 0, 0, 0, 3}}};
  for (const Method method : both) {
    const Outcome out = run(ball, start, 2, method);
    CAPTURE(name(method));
    const std::vector<double> sticks = times_of(out.report, EventKind::stick);
    REQUIRE(sticks.size() == 1);
    const double rolls = 2 * 2 / (7 * 0.2 * g);
    CHECK(sticks[0] == Approx(rolls).epsilon(1e-6));
    const double v = 2 * 5.0 / 7;
    CHECK((out.state.u - Eigen::VectorXd{{0.6 * v, 0.8 * v, 0, -0.8 * v / 0.5, 0.6 * v / 0.5, 3}}).norm() <
          1e-8);
    const double way = (2 + v) / 2 * rolls + v * (2 - rolls);
    CHECK((out.state.q - Eigen::Vector3d(0.6 * way, 0.8 * way, 0.5)).norm() < 1e-7);
    CHECK(energy_defect(ball, start, out) < 1e-8);
  }
}

TEST_CASE("Event to event: a disc stops sliding and spinning at the same time", "[integrate][hybrid]") {
  for (const double spin : {0.1, 1.0, 10.0}) {
    const SlidingDisc disc({.m = 1, .i = 0.4 * 0.04, .g = g}, {"floor", hertz, 0.2, 0.2});
    const State start{0, Eigen::Vector4d::Zero(), Eigen::Vector4d(1, 0, 0, spin)};
    for (const Method method : both) {
      const Outcome out = run(disc, start, 4, method, 1e-3);
      CAPTURE(name(method), spin);
      REQUIRE(out.report.events.size() == 1);  // one event for all of γ_F: no spin reversal, no stop before
      CHECK(out.report.events[0].kind == EventKind::stick);
      // Between the bounds for friction alone on sliding and on what both take together.
      CHECK(out.report.events[0].t >= 1 / (0.2 * g) * (1 - 1e-6));
      CHECK(out.state.u.norm() < 1e-14);
      CHECK(energy_defect(disc, start, out) < 1e-8);
    }
  }
  // Without sliding: spin falls at the rate μmg η₀R/I, η₀ = 3π/16.
  const SlidingDisc disc({.m = 1, .i = 0.02, .g = g}, {"floor", hertz, 0.2, 0.2});
  const State start{0, Eigen::Vector4d::Zero(), Eigen::Vector4d(0, 0, 0, 10)};
  for (const Method method : both) {
    const Outcome out = run(disc, start, 4, method, 1e-3);
    REQUIRE(out.report.events.size() == 1);
    CHECK(out.report.events[0].t == Approx(10 * 0.02 / (0.2 * g * 0.2 * 3 * M_PI / 16)).epsilon(1e-6));
    CHECK(out.report.dissipated[0].drilling == Approx(1).epsilon(1e-7));
    CHECK(out.report.dissipated[0].sliding == Approx(0).margin(1e-12));
  }
}

TEST_CASE("Event to event: a run can be continued", "[integrate][hybrid]") {
  const TippeTopAxis top = paper_top();
  const State start = top.start(0.1, 180, 0.02);  // falls, lands, slips
  IntegratorOptions options;
  options.tolerance = 1e-11;
  const Outcome whole = run(top, start, 0.3, options);
  Outcome part = run(top, start, 0.1, options);
  std::vector<Event> events = part.report.events;
  for (const double t : {0.17, 0.3}) {
    part = run(top, part.state, t, options);
    events.insert(events.end(), part.report.events.begin(), part.report.events.end());
  }
  REQUIRE(!events.empty());
  REQUIRE(events.size() == whole.report.events.size());
  for (std::size_t k = 0; k < events.size(); ++k) {
    CHECK(events[k].kind == whole.report.events[k].kind);
    CHECK(events[k].contact == whole.report.events[k].contact);
    CHECK(std::abs(events[k].t - whole.report.events[k].t) < 1e-9);
  }
  CHECK(difference(top, part.state, whole.state) < 1e-8);
}

TEST_CASE("Event to event: the observer sees multiples of the interval, in order", "[integrate][hybrid]") {
  const Slab slab({"floor", disk, 0.3, 0, 0.6});
  const State start{0.5, Eigen::Vector4d(0, 0, 0.2, 0), Eigen::Vector4d(1, 0, 0, 0)};
  for (const Method method : both) {
    IntegratorOptions options;
    options.method = method;
    options.step = 0.03;
    options.output_interval = 0.007;
    std::vector<double> shown;
    const Outcome out = run(slab, start, 2, options, [&](const Sample& s) {
      shown.push_back(s.t);
      CHECK(s.q[2] > -1e-12);
      if (s.modes[0] != ContactMode::open) CHECK(std::abs(s.q[2]) < 1e-9);
      // Free flight from 0.2 m is known.
      const double t = s.t - 0.5;
      if (t < 0.199) CHECK(std::abs(s.q[2] - (0.2 - g / 2 * t * t)) < 1e-13);
      if (t < 0.199) CHECK(std::abs(s.q[0] - t) < 1e-14);
    });
    REQUIRE(shown.size() == 216);
    for (std::size_t k = 0; k + 1 < shown.size(); ++k) CHECK(shown[k] == 0.5 + double(k) * 0.007);
    CHECK(shown.back() == 2);
    CHECK(out.report.status == RunStatus::finished);
  }
}

TEST_CASE("Event to event: ends before its end are said", "[integrate][hybrid]") {
  const TippeTopAxis top = paper_top();
  for (const Method method : both) {
    CAPTURE(name(method));
    IntegratorOptions options;
    options.method = method;
    options.max_steps = 5;
    const Outcome limited = run(top, top.start(0.1, 180), 1, options);
    CHECK(limited.report.status == RunStatus::step_limit);
    CHECK(limited.report.steps == 5);
    CHECK(limited.state.t < 1);
    CHECK(limited.state.q.allFinite());
    CHECK(limited.report.message.find("5 steps") != std::string::npos);

    // Numbers whose squares are none.
    options.max_steps = 1000;
    const Outcome mad = run(top, top.start(0.1, 1e200), 1, options);
    CHECK((mad.report.status == RunStatus::not_finite || mad.report.status == RunStatus::step_too_small));
    CHECK(!mad.report.message.empty());
    CHECK(mad.report.message.find('\n') == std::string::npos);
    CHECK(mad.state.q.allFinite());
    CHECK(mad.state.u.allFinite());

    State broken = top.start(0.1, 180);
    broken.u[4] = NAN;
    CHECK_THROWS_AS(run(top, broken, 1, options), std::invalid_argument);

    // An attitude where Euler's angles are none.
    const TippeTopEuler euler({}, tippe_top_contacts(hertz));
    CHECK_THROWS_AS(euler.start(0, 180), std::invalid_argument);
    State singular = euler.start(0.1, 180);
    singular.q[3] = 0;
    singular.q[2] = 0.012;
    const Outcome none = run(euler, singular, 1, options);
    CHECK(none.report.status == RunStatus::not_finite);
    CHECK(none.report.message.find("not finite") != std::string::npos);
  }
}
