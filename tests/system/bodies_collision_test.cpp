// Two bodies that meet: what impacts conserve and take, and one ball that rolls or slides off another.

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies_examples.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

/// Two balls of masses 0.2 and 0.5 kg, radii 0.1 and 0.15 m, surface 0 both.
BodiesData two_balls(const SystemContact& law) {
  BodiesData data;
  data.bodies = {ball("left", 0.2, 0.1, 0), ball("right", 0.5, 0.15, 0)};
  data.rules = {law};
  set_rules(data, 1, {{0, 0}});
  return data;
}

Vector3d momentum(const RigidBodies& system, const State& s) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < system.layout().bodies(); ++i)
    sum += system.data().bodies[i].mass * system.layout().velocity(i, s.u);
  return sum;
}

/// About the origin; of homogeneous balls.
Vector3d angular_momentum(const RigidBodies& system, const State& s) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < system.layout().bodies(); ++i) {
    const BodyData& body = system.data().bodies[i];
    sum += system.layout().position(i, s.q).cross(body.mass * system.layout().velocity(i, s.u)) +
           body.inertia[0] * system.layout().spin(i, s.t, s.q, s.u);
  }
  return sum;
}

State end_of(const RigidBodies& system, double t_end, RunReport& report, double tolerance = 1e-11) {
  State state = system.start();
  IntegratorOptions options;
  options.tolerance = tolerance;
  report = integrate(system, state, t_end, options);
  CHECK(report.status == RunStatus::finished);
  return state;
}

/// A small ball near the top of a large one that cannot turn and that the floor's friction holds where it is;
/// at rest, `theta` from the vertical, in a plane that is no plane of axes.
struct OnTop {
  static constexpr double theta = 0.2, r = 0.1, large = 0.4, g = 9.81;
  static inline const Vector3d aside = Vector3d(3, 4, 0) / 5;
  RigidBodies system;

  explicit OnTop(const SystemContact& law) : system(data(law)) {}
  static BodiesData data(const SystemContact& law) {
    BodiesData data;
    data.gravity = {0, 0, -g};
    BodyData block = ball("block", 1, large, 1);
    block.rotation = Rotation::none;
    block.position = {0, 0, large};
    BodyData small = ball("small", 0.1, r, 0);
    small.position =
        block.position + (large + r) * (std::sin(theta) * aside + std::cos(theta) * Vector3d::UnitZ());
    data.bodies = {block, small};
    data.planes = {floor_plane(2)};
    data.rules = {named(law, "balls"), named(coulomb_floor(1), "floor")};
    set_rules(data, 3, {{0, 1}, {1, 2}});
    return data;
  }
  /// cos of the angle from the vertical.
  double cosine(const State& s) const { return (s.q.segment<3>(3) - s.q.head<3>()).normalized()[2]; }
};

/// Runs to where the small ball leaves the large one, and returns the cosine of where that is.
double leaves_at(const OnTop& scene, RunReport& report, State& end) {
  State state = scene.system.start();
  IntegratorOptions options;
  options.tolerance = 1e-11;
  report = integrate(scene.system, state, 2, options);
  CHECK(report.status == RunStatus::finished);
  double left = 0;
  for (const Event& event : report.events) {
    if (event.kind == EventKind::open && event.contact == 0) left = event.t;
  }
  REQUIRE(left > 0);
  end = scene.system.start();
  report = integrate(scene.system, end, left, options);
  return scene.cosine(end);
}

}  // namespace

TEST_CASE("Two balls head-on: velocities and energy by restitution", "[system][bodies]") {
  for (const double restitution : {0.0, 0.5, 1.0}) {
    SystemContact law = smooth_floor();
    law.restitution = restitution;
    BodiesData data = two_balls(law);
    const Vector3d along = Vector3d(2, -1, 2) / 3;
    data.bodies[1].position = along;
    data.bodies[0].velocity = 3 * along;
    data.bodies[1].velocity = -along;
    const RigidBodies system(data);
    RunReport report;
    const State end = end_of(system, 0.5, report);
    REQUIRE(!report.events.empty());
    CHECK(report.events[0].kind == EventKind::close);
    CHECK(std::abs(report.events[0].t - 0.75 / 4) <= 1e-12);  // 1 m less both radii, at 4 m/s
    // Newton's law and momentum: v = v_centre ∓ (other mass/sum) (−ε)(approach)
    const double centre = (0.2 * 3 - 0.5) / 0.7;
    const double left = centre - 0.5 / 0.7 * restitution * 4;
    const double right = centre + 0.2 / 0.7 * restitution * 4;
    CHECK((end.u.head<3>() - left * along).norm() <= 1e-12);
    CHECK((end.u.segment<3>(6) - right * along).norm() <= 1e-12);
    const double lost = 0.5 * (0.2 * 0.5 / 0.7) * (1 - restitution * restitution) * 16;
    CHECK(std::abs(report.dissipated[0].impact - lost) <= 1e-12);
    CHECK(report.dissipated[0].sliding == 0);
  }
}

TEST_CASE("Two balls, oblique and spinning: momenta are conserved, energy goes where it is said",
          "[system][bodies]") {
  for (SystemContact law : {smooth_floor(), coulomb_floor(0.2), coulomb_floor(3), hertz_floor(0.2, 0.01)}) {
    law.restitution = 0.7;
    BodiesData data = two_balls(law);
    data.bodies[0].spin = {5, -20, 3};
    data.bodies[1].spin = {-8, 2, 11};
    data.bodies[0].velocity = {3, 0.4, 0};
    data.bodies[1].position = {0.9, 0.15, 0.1};
    data.bodies[1].velocity = {-1, 0, 0.1};
    const RigidBodies system(data);
    const State start = system.start();
    RunReport report;
    const State end = end_of(system, 0.6, report);
    REQUIRE(report.events.size() >= 2);
    CHECK((momentum(system, end) - momentum(system, start)).norm() <= 1e-13);
    CHECK((angular_momentum(system, end) - angular_momentum(system, start)).norm() <= 1e-12);
    const double lost = system.kinetic_energy(start.q, start.u) - system.kinetic_energy(end.q, end.u);
    CHECK(lost > 0);
    CHECK(std::abs(report.dissipated[0].total() - lost) <= 1e-11);
  }
}

TEST_CASE("A ball slides off another without friction where cos is two thirds of the start's",
          "[system][bodies]") {
  RunReport report;
  State end;
  const OnTop scene(smooth_floor());
  const double cosine = leaves_at(scene, report, end);
  CHECK(std::abs(cosine - 2.0 / 3 * std::cos(OnTop::theta)) <= 1e-8);
  CHECK(std::abs(end.q.segment<3>(3).cross(OnTop::aside)[2]) <= 1e-9);  // in its plane
  CHECK((end.q.head<3>() - Vector3d(0, 0, OnTop::large)).norm() <= 1e-9);
}

TEST_CASE("A ball rolls off another: energy in rolling, and where it leaves", "[system][bodies]") {
  RunReport report;
  State end;
  const OnTop scene(coulomb_floor(1e4));
  const double cosine = leaves_at(scene, report, end);
  // Rolling to the last: (7/10)v² = g(R + r)(cosθ₀ − cosθ) and v² = g(R + r) cosθ, so 10/17; slip begins
  // where λ_N is 1e-4 of what friction needs, and takes that part.
  CHECK(std::abs(cosine - 10.0 / 17 * std::cos(OnTop::theta)) <= 1e-3);
  const State start = scene.system.start();
  const auto energy = [&](const State& s) {
    return scene.system.kinetic_energy(s.q, s.u) + scene.system.potential_energy(s.q);
  };
  CHECK(std::abs(energy(end) + report.dissipated[0].total() - energy(start)) <= 1e-8);
  CHECK(report.dissipated[0].total() <= 1e-4);
}

TEST_CASE("A ball in a corner: two contacts at once", "[system][bodies]") {
  BodiesData data;
  data.gravity = {0, 0, -9.81};
  BodyData body = ball("ball", 0.3, 0.1, 0);
  body.position = {0.1, 0, 0.1};
  body.spin = {0, -30, 0};  // drives it into the wall: the floor pushes it there, the wall lifts
  data.bodies = {body};
  data.planes = {floor_plane(1), {"wall", Vector3d::UnitX(), 0, 2}};
  data.rules = {named(coulomb_floor(0.3), "floor"), named(coulomb_floor(0.3), "wall")};
  set_rules(data, 3, {{0, 1}, {0, 2}});
  const RigidBodies system(data);
  RunReport report;
  const State end = end_of(system, 2, report);
  // N_floor = mg/(1 + μ²), N_wall = μ N_floor; their friction brakes: I ω̇ = −μ r (N_floor + N_wall).
  const double braking = 2.5 * 0.3 * 9.81 * 1.3 / (1.09 * 0.1);
  REQUIRE(!report.events.empty());
  CHECK(std::abs(report.events[0].t - 30 / braking) <= 1e-9);
  CHECK(end.u.norm() <= 1e-12);
  const double before = system.kinetic_energy(system.start().q, system.start().u);
  CHECK(std::abs(before + system.potential_energy(system.start().q) - system.kinetic_energy(end.q, end.u) -
                 system.potential_energy(end.q) - report.dissipated[0].total() -
                 report.dissipated[1].total()) <= 1e-9);
}

TEST_CASE("A ball in a groove: two contacts that repeat each other", "[system][bodies]") {
  // Along the line through both points they hold each other, whatever the friction that takes: forces are not
  // unique. Rolling down the groove is: μN = 2.1 N/kg at each, while rolling needs 0.22 of gravity along it.
  for (const double along : {0.0, 1.0, 6.0}) {
    BodiesData data;
    data.gravity = {0.2, along, -9.81};
    BodyData body = ball("ball", 0.3, 0.1, 0);
    body.position = {0, 0, 0.1 * std::sqrt(2.0)};
    body.spin = {-10, 4, 25};
    data.bodies = {body};
    data.planes = {{"left", Vector3d(1, 0, 1).normalized(), 0, 1},
                   {"right", Vector3d(-1, 0, 1).normalized(), 0, 2}};
    data.rules = {named(coulomb_floor(0.3), "left"), named(coulomb_floor(0.3), "right")};
    set_rules(data, 3, {{0, 1}, {0, 2}});
    const RigidBodies system(data);
    State early = system.start();
    IntegratorOptions options;
    options.max_steps = 5000;
    const RunReport to_rolling = integrate(system, early, 1, options);
    CHECK(to_rolling.status == RunStatus::finished);
    State late = early;
    const RunReport rolling = integrate(system, late, 2, options);
    CHECK(rolling.status == RunStatus::finished);
    // At r/√2 from the axis it rolls about, with I = 2/5 mr²: a = g/(1 + 4/5).
    CHECK(std::abs(late.u[1] - early.u[1] - along / 1.8) <= 1e-7);
    CHECK(std::abs(rolling.dissipated[0].total() + rolling.dissipated[1].total()) <= 1e-7);
  }
}
