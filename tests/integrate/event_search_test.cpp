#include "contensou/integrate/event_search.hpp"

#include <catch2/catch.hpp>

#include "../system/bodies_examples.hpp"
#include "contensou/integrate/classic_rk4.hpp"
#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

constexpr double g = Slab::g, m = Slab::m;
constexpr double rounding = 1e-14;  // of times of size 1
const AnyFriction disk{FrictionDisk{}};

/// One step of DOP853 (or RK4: exact too for parabolas) from a state with given modes, and the search in it.
struct Step {
  const MechanicalSystem& system;
  State start;
  std::vector<ContactMode> modes;
  double h;
  MotionScales scales = motion_scales(system, start);
  ContactDynamics dynamics{system};
  EventSearch search{dynamics, scales, modes};
  Dop853 method{};
  ClassicRk4 low_order{};
  OdeStep* stepper = &method;
  Eigen::VectorXd y{}, rate{}, scale{};

  /// `fresh`: the first contact has just opened.
  std::optional<EventSearch::Found> find(bool fresh = false) {
    y.setZero(dynamics.size());
    rate.setZero(dynamics.size());
    scale.setOnes(dynamics.size());
    y.head(system.coordinates()) = start.q;
    y.segment(system.coordinates(), system.velocities()) = start.u;
    dynamics.set_modes(modes);
    if (fresh) search.disarm_touching(start.t, start.q);
    dynamics.derivative(start.t, y, rate);
    search.begin(start.t, y);
    stepper->attempt(dynamics, start.t, y, rate, h, scale);
    return search.find(*stepper, start.t, h);
  }
  std::optional<double> land(const EventSearch::Found& found) {
    return search.land(*stepper, start.t, y, rate, h, scale, found);
  }
};

}  // namespace

TEST_CASE("EventSearch: falling on the floor", "[integrate]") {
  const Slab slab({"floor", disk, 0.5});
  for (const double v : {0.0, -3.0, 2.0}) {
    const double landing = (v + std::sqrt(v * v + 2 * g * 0.7)) / g;
    for (const double h : {landing * 1.001, landing * 3, landing * (1 + 1e-9)}) {
      Step step{slab, Slab::at(0.7, {1, 0, v, 0}), {ContactMode::open}, h};
      for (OdeStep* stepper : {static_cast<OdeStep*>(&step.method), static_cast<OdeStep*>(&step.low_order)}) {
        step.stepper = stepper;
        const auto found = step.find();
        CAPTURE(v, h);
        REQUIRE(found);
        CHECK(found->contact == 0);
        CHECK(std::abs(found->theta * h - landing) < 10 * rounding);
        const auto length = step.land(*found);
        REQUIRE(length);
        CHECK(std::abs(*length - landing) < rounding);
        CHECK(std::abs(stepper->end()[2]) <= 1e-15);
      }
    }
    Step before{slab, Slab::at(0.7, {1, 0, v, 0}), {ContactMode::open}, landing * 0.999};
    CHECK(!before.find());
  }
}

TEST_CASE("EventSearch: a contact that has just opened is watched once it has risen", "[integrate]") {
  const Slab slab({"floor", disk, 0.5});
  // Bounces at g_N = 0 within rounding, that rise and fall within one step.
  for (const double v : {1.0, 1e-3}) {
    for (const double gap : {0.0, 1e-16, -1e-16}) {
      const double flight = 2 * v / g;
      for (const double h : {1.1 * flight, 3 * flight, 50 * flight}) {
        Step step{slab, Slab::at(gap, {0, 0, v, 0}), {ContactMode::open}, h};
        const auto found = step.find(true);
        CAPTURE(v, gap, h);
        REQUIRE(found);
        const auto length = step.land(*found);
        REQUIRE(length);
        CHECK(std::abs(*length - flight) < rounding + 2e-16 / v);
      }
      Step rises{slab, Slab::at(gap, {0, 0, v, 0}), {ContactMode::open}, 0.5 * flight};
      CHECK(!rises.find(true));
      CHECK(rises.search.fresh(0));
      rises.search.accept(rises.h, rises.method.end());
      CHECK(!rises.search.fresh(0));
    }
  }
}

TEST_CASE("EventSearch: a dip between the ends of a step", "[integrate]") {
  // Pushed up with 4mg: z = z₀ − vt + 3g/2 t².
  const Slab slab({"floor", disk, 0.5}, [](double) { return Eigen::Vector4d(0, 0, 4 * m * g, 0); });
  const double v = 3, a = 3 * g;
  for (const double depth : {0.02, 0.002, 1e-5}) {
    const double z = v * v / (2 * a) - depth, turn = v / a;
    const double entry = turn - std::sqrt(2 * depth / a);
    Step step{slab, Slab::at(z, {0, 0, -v, 0}), {ContactMode::open}, 1.9 * turn};
    REQUIRE(z - v * step.h + a / 2 * step.h * step.h > 0);
    const auto found = step.find();
    CAPTURE(depth);
    REQUIRE(found);
    const auto length = step.land(*found);
    REQUIRE(length);
    CHECK(std::abs(*length - entry) < rounding + 1e-15 / std::sqrt(2 * a * depth));
  }
  Step above{slab, Slab::at(v * v / (2 * a) + 1e-6, {0, 0, -v, 0}), {ContactMode::open}, 1.9 * v / a};
  CHECK(!above.find());
}

TEST_CASE("EventSearch: a contact is lifted, a contact loses its hold", "[integrate]") {
  // Forces that grow with time: mg(1 + t)/2 upwards, μmg(1 + t)/2 along the floor.
  const Slab lifted({"floor", disk, 0.5},
                    [](double t) { return Eigen::Vector4d(0, 0, m * g * (1 + t) / 2, 0); });
  Step opens{lifted, Slab::at(0, {0, 0, 0, 0}), {ContactMode::stick}, 1.3};
  const auto found = opens.find();
  REQUIRE(found);
  CHECK(found->contact == 0);
  const auto length = opens.land(*found);
  REQUIRE(length);
  // Events of forces are looked for 1e-10 of their scale (mg/2 here) beyond zero.
  CHECK(*length - 1 > 0);
  CHECK(*length - 1 < 1.01e-10);

  const Slab pushed({"floor", disk, 0.5}, [](double t) -> Eigen::Vector4d {
    return Eigen::Vector4d(0.3, 0.4, 0, 0) * (m * g * (1 + t) / 2);
  });
  Step slips{pushed, Slab::at(0, {0, 0, 0, 0}), {ContactMode::stick}, 1.3};
  const auto limit = slips.find();
  REQUIRE(limit);
  const auto until = slips.land(*limit);
  REQUIRE(until);
  CHECK(*until - 1 > 0);
  CHECK(*until - 1 < 2.01e-10);
  Step holds{pushed, Slab::at(0, {0, 0, 0, 0}), {ContactMode::stick}, 0.999};
  CHECK(!holds.find());
}

TEST_CASE("EventSearch: the first of two events", "[integrate]") {
  // The top falls flat on body and tip: whichever is lower comes first.
  const TippeTopAxis top = paper_top();
  const TippeTopData& d = top.data();
  const double flat = std::acos((d.r1 - d.r2) / (d.a1 - d.a2));
  for (const double tilt : {-0.01, 0.01}) {
    State start = top.start(flat + tilt, 0, 0.03);
    Step step{top, start, {ContactMode::open, ContactMode::open}, 0.08};
    const auto found = step.find();
    CAPTURE(tilt);
    REQUIRE(found);
    CHECK(found->contact == (tilt > 0 ? 1 : 0));
    const auto length = step.land(*found);
    REQUIRE(length);
    const double fall = std::min(top.gap(0, 0, start.q), top.gap(1, 0, start.q));
    CHECK(std::abs(*length - std::sqrt(2 * fall / d.g)) < rounding);
  }
}

TEST_CASE("EventSearch: spin changes its sign while the contact slides", "[integrate]") {
  const Slab slab({"floor", system_test::hertz, 0.1, 0.02},
                  [](double) { return Eigen::Vector4d(0, 0, 0, -3); });
  Step step{slab, Slab::at(0, {2, 0, 0, 0.5}), {ContactMode::slip}, 0.1};
  CHECK(!step.find());
  const auto theta = step.search.spin_reversal(step.method, 0, step.h, 0);
  REQUIRE(theta);
  CHECK(*theta > 0);
  CHECK(*theta < 1);
  // A step to there has spin zero, as far as the extension's accuracy goes.
  Dop853 again;
  again.attempt(step.dynamics, 0, step.y, step.rate, *theta * step.h, step.scale);
  CHECK(std::abs(again.end()[7]) < 1e-10);
  Step shorter{slab, Slab::at(0, {2, 0, 0, 0.5}), {ContactMode::slip}, 0.9 * *theta * step.h};
  CHECK(!shorter.find());
  CHECK(!shorter.search.spin_reversal(shorter.method, 0, shorter.h, 0));
}

TEST_CASE("EventSearch: a closing that the step has undone before another one at its end", "[integrate]") {
  // A ball at 10 m/s in a step that ends behind another ball, which it meets at 0.08 s, and in or behind a
  // wall, which it would meet in that ball or behind it.
  for (const double wall : {0.1, 1.0}) {
    BodiesData data;
    data.bodies = {system_test::ball("thrown", 1, 0.1, 0), system_test::ball("hit", 1, 0.1, 1)};
    data.bodies[0].position = {-1, 0, 0};
    data.bodies[0].velocity = {10, 0, 0};
    data.planes = {{"wall", -Eigen::Vector3d::UnitX(), -wall, 2}};
    data.rules = {{"pair", AnyFriction{NoFriction{}}, 0, 0, 1}, {"wall", AnyFriction{NoFriction{}}, 0, 0, 1}};
    system_test::set_rules(data, 3, {{0, 1}, {0, 2}});
    const RigidBodies system(data);
    const std::size_t pair = system.contacts()[0].name == "pair" ? 0 : 1;
    Step step{system, system.start(), {ContactMode::open, ContactMode::open}, 0.25};
    const auto found = step.find();
    CAPTURE(wall);
    REQUIRE(found);
    CHECK(found->contact == pair);
    CHECK(std::abs(found->theta * step.h - 0.08) < rounding);
  }
}
