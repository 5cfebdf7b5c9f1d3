#include "contensou/integrate/contact_instant.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "../system/tippe_top_states.hpp"
#include "contensou/integrate/motion_scales.hpp"
#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/point_mass.hpp"
#include "contensou/system/sliding_disc.hpp"

using namespace contensou;

namespace {

constexpr auto open = ContactMode::open;
constexpr auto slip = ContactMode::slip;
constexpr auto stick = ContactMode::stick;
const AnyFriction frictionless{NoFriction{}};
const AnyFriction& disk = system_test::point;
const AnyFriction& hertz = system_test::hertz;
constexpr double rounding = 1e-13;  // of velocities of size 1; contact problems are solved to 1e-12 of theirs
constexpr InstantTolerances tolerances{.approach = 1e-10, .bounce = 1e-6, .slip = 1e-8, .length = 1};

struct Outcome {
  State state;
  std::vector<ContactMode> modes;
  std::vector<bool> struck;
  RunReport report;
};

/// An instant with all contacts closed.
Outcome settled(const MechanicalSystem& system, const State& state, InstantTolerances t = tolerances) {
  const std::size_t count = system.contacts().size();
  Outcome out{state, std::vector<ContactMode>(count, slip), {}, {}};
  out.report.dissipated.resize(count);
  ContactInstant instant(system, 1e-12);
  REQUIRE(instant.settle(out.state, out.modes, t, out.report));
  for (std::size_t i = 0; i < count; ++i) out.struck.push_back(instant.struck(i));
  CHECK(out.state.q == state.q);
  CHECK(out.state.t == state.t);
  return out;
}

/// What went out of the kinetic energy is what the report says.
void check_energy(const MechanicalSystem& system, const State& before, const Outcome& after, double scale) {
  double lost = 0;
  for (const Dissipation& d : after.report.dissipated) {
    lost += d.impact;
    CHECK(d.sliding == 0);
    CHECK(d.drilling == 0);
  }
  const double change =
      system.kinetic_energy(before.q, before.u) - system.kinetic_energy(after.state.q, after.state.u);
  CHECK(std::abs(change - lost) < 1e-13 * scale);
}

State moving(Eigen::Vector3d u) { return {0.3, Eigen::Vector3d::Zero(), u}; }

}  // namespace

TEST_CASE("ContactInstant: impact of a point mass", "[integrate]") {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    const PointMass mass({.m = 2}, {"floor", disk, 0.3, 0, restitution});
    const double bounce = 2 * restitution;
    // Friction takes μ(1 + ε)·2 m/s from the sliding speed, and not more than all.
    const State fast = moving({3, -4, -2});
    const Outcome slides = settled(mass, fast);
    const double left = 5 - 0.3 * (2 + bounce);
    CAPTURE(restitution);
    CHECK((slides.state.u - Eigen::Vector3d(0.6 * left, -0.8 * left, bounce)).norm() < 10 * rounding);
    CHECK(slides.struck[0]);
    CHECK(slides.modes[0] == (restitution > 0 ? open : slip));
    check_energy(mass, fast, slides, 30);

    const State slow = moving({0.3, -0.4, -2});
    const Outcome stops = settled(mass, slow);
    CHECK((stops.state.u - Eigen::Vector3d(0, 0, bounce)).norm() < 10 * rounding);
    CHECK(stops.modes[0] == (restitution > 0 ? open : stick));
    check_energy(mass, slow, stops, 10);
  }
}

TEST_CASE("ContactInstant: impact of a ball", "[integrate]") {
  // Point contact: an impulse P at the contact point changes v by P/m and rω by (5/2)P/m; slip by (7/2)P/m.
  const BallOnPlane ball({.m = 2, .r = 0.5}, {"floor", disk, 0.1, 0, 0.6});
  State state{0, Eigen::Vector3d(0, 0, 0.5), Eigen::VectorXd{{3, 0, -2, 0, 0, 1}}};
  const Outcome slides = settled(ball, state);
  const double p = 0.1 * 1.6 * 2;  // per mass, against +x: slip of 3 m/s is far from stopped
  CHECK((slides.state.u - Eigen::VectorXd{{3 - p, 0, 1.2, 0, 2.5 * p / 0.5, 1}}).norm() < 10 * rounding);
  check_energy(ball, state, slides, 20);
  state.u << 0.3, 0, -2, 0, 0, 1;  // 2/7 of the slip speed go
  const Outcome rolls = settled(ball, state);
  CHECK((rolls.state.u - Eigen::VectorXd{{0.3 * 5 / 7, 0, 1.2, 0, 0.3 * 5 / 7 / 0.5, 1}}).norm() <
        10 * rounding);
  check_energy(ball, state, rolls, 20);
}

TEST_CASE("ContactInstant: impact with a patch obeys the law", "[integrate]") {
  // The impulse is that of friction at the velocity after: −Λ_F/(μΛ_N) is the law's border point there.
  const SlidingDisc disc({.m = 2, .i = 0.3}, {"floor", hertz, 0.2, 0.4, 0.5});
  const State state{0, Eigen::Vector4d::Zero(), Eigen::Vector4d(2, -1, -1.5, 3)};
  const Outcome out = settled(disc, state);
  const Eigen::Vector4d change = out.state.u - state.u;
  const double normal = 2 * change[2];
  CHECK(normal == Approx(2 * 1.5 * 1.5).epsilon(1e-12));
  const Eigen::Vector3d impulse(2 * change[0], 2 * change[1], 0.3 * change[3] / 0.4);
  const Eigen::Vector3d after(out.state.u[0], out.state.u[1], 0.4 * out.state.u[3]);
  const auto law = std::get<FrictionForce>(friction_force(HertzLaw{}, {0.2, normal}, after));
  CHECK((impulse - law).norm() < 1e-11);
  check_energy(disc, state, out, 10);
}

TEST_CASE("ContactInstant: a top's impact is that of the impact law", "[integrate]") {
  for (State s : system_test::euler_states()) {
    s.u[2] = -2;
    const TippeTopEuler top(system_test::solid, tippe_top_contacts(hertz, 0.3, 0.05, 0.4));
    const Outcome out = settled(top, s);
    // assemble_impact and a solver, from the system's own terms.
    Eigen::MatrixXd mass(6, 6);
    top.mass_matrix(s.q, mass);
    ImpactStep step{mass.inverse(),           Eigen::MatrixXd(6, 8),    s.u,
                    Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(8), Eigen::Vector2d(0.4, 0.4)};
    step.inverse_mass = (step.inverse_mass + step.inverse_mass.transpose()).eval() / 2;
    bool approaching = false;
    for (const std::size_t i : {0, 1}) {
      ContactRows rows(6);
      top.contact_rows(i, s.t, s.q, s.u, rows);
      step.directions.middleCols(4 * Eigen::Index(i), 4) = rows.directions;
      approaching = approaching || rows.velocity[0] < 0;
      CHECK(out.struck[i] == (rows.velocity[0] < 0));
    }
    REQUIRE(approaching);
    ContactProblem problem;
    problem.groups = {{&hertz, {0.3}}, {&hertz, {0.3}}};
    Eigen::MatrixXd response;
    assemble_impact(step, response, problem);
    ContactSolver solver;
    Eigen::VectorXd impulse;
    REQUIRE(solver.solve(problem, impulse).status == SolverStatus::solved);
    CHECK((out.state.u - velocity_after(step, response, impulse)).norm() < 1e-9);
    check_energy(top, s, out, 10);
  }
}

TEST_CASE("ContactInstant: approach and departure have their tolerances", "[integrate]") {
  const PointMass mass({}, {"floor", frictionless, 0, 0, 0.5});
  const auto after = [&](double speed) { return settled(mass, moving({0, 0, speed})); };
  const Outcome touching = after(-0.9e-10);  // no impact
  CHECK(!touching.struck[0]);
  CHECK(touching.modes[0] == slip);
  CHECK(touching.state.u[2] == 0);
  const Outcome impact = after(-1e-5);  // bounces at 0.5e-5
  CHECK(impact.struck[0]);
  CHECK(impact.modes[0] == open);
  CHECK(impact.state.u[2] == Approx(0.5e-5).epsilon(1e-9));
  const Outcome low = after(-1e-6);  // a bounce too low to be one: the rest is taken out, too
  CHECK(low.struck[0]);
  CHECK(low.modes[0] == slip);
  CHECK(low.state.u[2] == 0);
  CHECK(low.report.dissipated[0].impact == Approx(0.5e-12).epsilon(1e-9));
  const Outcome leaving = after(1.1e-10);  // without an impact
  CHECK(!leaving.struck[0]);
  CHECK(leaving.modes[0] == open);
  CHECK(leaving.state.u[2] == 1.1e-10);
  const Outcome staying = after(0.9e-10);
  CHECK(staying.modes[0] == slip);
  CHECK(staying.state.u[2] == 0);
}

TEST_CASE("ContactInstant: a contact that is pulled opens", "[integrate]") {
  const PointMass hanging({.m = 1, .g = 9.81, .tilt = 0}, {"floor", disk, 0.5});
  CHECK(settled(hanging, moving({0, 0, 0})).modes[0] == stick);
  // A top that turns over its tip so fast that the centre flies off: −I don't press where ω² a > g.
  const TippeTopAxis top(system_test::solid, tippe_top_contacts(frictionless));
  State state = top.start(0.3, 0);
  for (const double omega : {0.5, 50.0}) {
    state.u << 0, 0, 0, omega, 0, 0;
    ContactRows rows(6);
    top.contact_rows(0, 0, state.q, state.u, rows);
    state.u[2] -= rows.velocity[0];
    ContactDynamics dynamics(top);
    dynamics.set_modes({slip, open});
    Eigen::VectorXd y(16), dy(16);
    y << state.q, state.u, Eigen::VectorXd::Zero(4);
    dynamics.derivative(0, y, dy);
    std::vector<ContactMode> modes{slip, open};
    RunReport report;
    report.dissipated.resize(2);
    ContactInstant instant(top, 1e-12);
    REQUIRE(instant.settle(state, modes, tolerances, report));
    CHECK(modes[0] == (dynamics.force(0)[0] > 0 ? slip : open));
    CHECK(modes[1] == open);
  }
}

TEST_CASE("ContactInstant: slow slip stops where friction can hold, and only there", "[integrate]") {
  // tan(tilt) against μ = 0.5.
  for (const double slope : {0.4, 0.499999, 0.500001, 0.6}) {
    const PointMass mass({.m = 2, .tilt = std::atan(slope)}, {"floor", disk, 0.5});
    const State creeping = moving({3e-9, 4e-9, 0});
    const Outcome slow = settled(mass, creeping);
    CAPTURE(slope);
    CHECK(slow.modes[0] == (slope < 0.5 ? stick : slip));
    if (slope < 0.5) {
      CHECK(slow.state.u == Eigen::Vector3d::Zero());
    } else {  // starts down the plane, slowly, but not to be stopped again
      CHECK((slow.state.u - Eigen::Vector3d(2e-8, 0, 0)).norm() < 1e-20);
    }
    const Outcome faster = settled(mass, moving({3e-8, 4e-8, 0}));
    CHECK(faster.modes[0] == slip);
    CHECK(faster.state.u == Eigen::Vector3d(3e-8, 4e-8, 0));
    check_energy(mass, creeping, slow, 1e-3);  // 1e-16 J
  }
}

TEST_CASE("ContactInstant: a patch starts to slip along the normal of its friction ball", "[integrate]") {
  // A disc on a plane does not start by itself; a ball on an incline of more than 7/2 μ does, point contact
  // or patch: down the plane, without spin.
  for (const AnyFriction* friction : {&disk, &hertz}) {
    for (const double share : {0.99, 1.01}) {
      const BallOnPlane ball({.m = 1, .r = 0.5, .tilt = std::atan(share * 3.5 * 0.1)},
                             {"floor", *friction, 0.1, 0.01});
      const State rest{0, Eigen::Vector3d(0, 0, 0.5), Eigen::VectorXd::Zero(6)};
      const Outcome out = settled(ball, rest);
      CAPTURE(share);
      CHECK(out.modes[0] == (share < 1 ? stick : slip));
      ContactRows rows(6);
      ball.contact_rows(0, 0, out.state.q, out.state.u, rows);
      const double spin = friction == &hertz ? rows.velocity[3] : 0;
      CHECK(rows.velocity[0] == Approx(0).margin(1e-20));
      CHECK(rows.velocity[1] == Approx(share < 1 ? 0 : 2e-8).epsilon(1e-6).margin(1e-20));
      CHECK(rows.velocity[2] == Approx(0).margin(1e-14));
      CHECK(spin == Approx(0).margin(1e-14));
    }
  }
}

TEST_CASE("ContactInstant: velocities and positions of closed contacts are corrected to rounding",
          "[integrate]") {
  const TippeTopAxis axis(system_test::solid, tippe_top_contacts(hertz, 0.3, 0.05));
  const TippeTopEuler euler(system_test::solid, tippe_top_contacts(hertz, 0.3, 0.05));
  for (const TippeTopModel* top :
       {static_cast<const TippeTopModel*>(&axis), static_cast<const TippeTopModel*>(&euler)}) {
    // Both contacts: body and tip near the floor, and one at a time.
    const double theta = std::acos((1.5 - 0.5) / (0.3 - 1.6));
    for (const std::vector<ContactMode>& modes :
         {std::vector<ContactMode>{slip, open}, {open, stick}, {slip, slip}, {slip, stick}, {stick, stick}}) {
      State state = top->start(theta, 2);
      state.q[2] += 1e-5;
      state.q[3] += 1e-5;
      top->restore(state.q);
      state.u.head<3>() += Eigen::Vector3d(0.1, 0.2, 1e-3);
      state.u.tail<3>() += Eigen::Vector3d(1, 0.2, 0.3);
      const State before = state;
      ContactInstant instant(*top, 1e-12);
      RunReport report;
      report.dissipated.resize(2);
      instant.correct_positions(state, modes);
      CHECK(state.u == before.u);
      CHECK((state.q - before.q).norm() < 1e-4);
      const double energy = top->kinetic_energy(state.q, state.u);
      instant.correct_velocities(state, modes, report);
      CAPTURE(int(modes[0]), int(modes[1]));
      for (const std::size_t i : {0, 1}) {
        if (modes[i] == open) continue;
        // A correction of 1e-5 made twice: 1e-10 of it squared is left of the first, and 1e-20 of the second.
        CHECK(std::abs(top->gap(i, 0, state.q)) < 1e-14);
        ContactRows rows(6);
        top->contact_rows(i, 0, state.q, state.u, rows);
        CHECK(std::abs(rows.velocity[0]) < 1e-12);
        if (modes[i] == stick) CHECK(rows.velocity.tail<3>().norm() < 1e-12);
      }
      const double lost = report.dissipated[0].impact + report.dissipated[1].impact;
      CHECK(lost == Approx(energy - top->kinetic_energy(state.q, state.u)).epsilon(1e-11));
      CHECK(lost >= 0);
      const State once = state;
      instant.correct_positions(state, modes);
      CHECK((state.q - once.q).norm() < 1e-14);
    }
  }
}

TEST_CASE("ContactInstant: what is not finite is said", "[integrate]") {
  const PointMass mass({}, {"floor", disk, 0.5});
  ContactInstant instant(mass, 1e-12);
  State state = moving({0, NAN, -1});
  std::vector<ContactMode> modes{slip};
  RunReport report;
  report.dissipated.resize(1);
  CHECK(!instant.settle(state, modes, tolerances, report));
  CHECK(report.status == RunStatus::not_finite);
  CHECK(report.message.find("not finite") != std::string::npos);
}
