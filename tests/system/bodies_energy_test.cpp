// E_0 + work + driven = E_1 + dissipated, in all integrators.

#include <catch2/catch.hpp>
#include <cmath>

#include "bodies_examples.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Vector3d;

namespace {

struct Books {
  double difference;  ///< E_0 + work + driven − E_1 − dissipated
  double work, driven, dissipated;
  State end;
  RunReport report;
};

Books books(const RigidBodies& system, double t_end, const IntegratorOptions& options) {
  const State start = system.start();
  Books b{0, 0, 0, 0, start, {}};
  b.report = integrate(system, b.end, t_end, options);
  CAPTURE(name(options.method), b.report.message);
  CHECK(b.report.status == RunStatus::finished);
  CHECK(b.report.work.size() == system.works().size());
  for (const double work : b.report.work) b.work += work;
  for (const Dissipation& d : b.report.dissipated) {
    b.driven += d.driven;
    b.dissipated += d.total();
  }
  const auto energy = [&](const State& s) {
    return system.kinetic_energy(s.q, s.u) + system.potential_energy(s.q);
  };
  b.difference = energy(start) + b.work + b.driven - energy(b.end) - b.dissipated;
  return b;
}

IntegratorOptions options(Method method, double step, double tolerance = 1e-10) {
  IntegratorOptions o;
  o.method = method;
  o.step = step;
  o.tolerance = tolerance;
  return o;
}

/// The books of fixed steps close by the order of the method: their difference at step h and at h/2.
void check_order(const RigidBodies& system, double t_end, Method method, double step, double least,
                 double most) {
  const double coarse = std::abs(books(system, t_end, options(method, step)).difference);
  const double fine = std::abs(books(system, t_end, options(method, step / 2)).difference);
  CAPTURE(name(method), coarse, fine);
  CHECK(std::log2(coarse / fine) > least);
  CHECK(std::log2(coarse / fine) < most);
}

/// A projectile that spins, with drag of both kinds.
BodiesData flight() {
  BodiesData data;
  data.gravity = {0, 0, -9.81};
  BodyData body = ball("ball", 0.4, 0.1, 0);
  body.inertia = {0.0016, 0.002, 0.0024};
  body.velocity = {8, -3, 5};
  body.spin = {10, 4, -7};
  body.drag = {0.2, 0.001};
  data.bodies = {body};
  set_rules(data, 1, {});
  return data;
}

/// A polishing machine: a disc that is told to spin, on its base, pushed to and fro.
BodiesData polisher(double spin, const SystemContact& law) {
  BodiesData data;
  data.gravity = {0, 0, -9.81};
  BodyData disc;
  disc.name = "machine";
  disc.rotation = Rotation::driven;
  disc.mass = 6;
  disc.base = BaseData{"base", 0.2, 0};
  disc.position = {0, 0, 0.2};
  disc.spin = {0, 0, spin};
  disc.velocity = {0.3, 0.1, 0};
  data.bodies = {disc};
  data.planes = {floor_plane(1)};
  data.rules = {law};
  data.loads = {{"push", 0, {4, 0, -20}, {0, 0, 0}, {{}, {}, 0.7, 0.3}},
                {"pull", 0, {0, 3, 0}, {0, 0, 0}, {}}};
  set_rules(data, 2, {{0, 1}});
  return data;
}

/// A driven body with a sphere off its axis, that hops on the floor: its given motion has a part along n.
BodiesData hopper() {
  SystemContact law = coulomb_floor(0.4);
  law.restitution = 0.5;
  BodiesData data;
  data.gravity = {0, 0, -9.81};
  BodyData body = ball("hopper", 1.2, 0.1, 0);
  body.rotation = Rotation::driven;
  body.spheres[0].centre = {0.05, 0, 0.02};
  body.position = {0, 0, 0.3};
  body.spin = {3, 12, 5};
  data.bodies = {body};
  data.planes = {floor_plane(1)};
  data.rules = {law};
  set_rules(data, 2, {{0, 1}});
  return data;
}

constexpr double tight = 1e-10;

}  // namespace

TEST_CASE("Energy: drag of the air, with its closed form", "[system][bodies]") {
  const RigidBodies system(flight());
  CHECK(system.works() == std::vector<std::string>{"air drag"});
  const Books b = books(system, 1.5, options(Method::event_driven, 1e-3, tight));
  // m v̇ = mg − c v
  const double rate = 0.2 / 0.4, left = std::exp(-rate * 1.5);
  const Vector3d limit(0, 0, -9.81 / rate);
  const Vector3d expected = limit + left * (Vector3d(8, -3, 5) - limit);
  CHECK((b.end.u.head<3>() - expected).norm() <= 1e-8);
  CHECK(b.work < -1);
  CHECK(std::abs(b.difference) <= 1e-8);  // tolerance × energy × steps
  CHECK(std::abs(books(system, 1.5, options(Method::rk4, 1e-3)).difference) <= 1e-8);
  // By the order of the method.
  check_order(system, 1.5, Method::moreau, 4e-3, 1.8, 2.2);
  for (const Method method : {Method::moreau_implicit, Method::moreau_printed, Method::rk4_printed})
    check_order(system, 1.5, method, 4e-3, 0.8, 1.2);
}

TEST_CASE("Energy: loads and a driven disc, slipping", "[system][bodies]") {
  for (const SystemContact& law : {uniform_floor(0.3, 0.2), coulomb_floor(0.3)}) {
    const RigidBodies system(polisher(30, law));
    CHECK(system.works() == std::vector<std::string>{"load push", "load pull"});
    const bool drills = rows(law.friction) > 3;
    const Books b = books(system, 1, options(Method::event_driven, 1e-3, tight));
    CHECK(std::abs(b.work) > 1e-3);
    CHECK(std::abs(b.difference) <= 1e-8 * (1 + b.dissipated));
    // What the motor puts in is what drilling takes: nothing else turns.
    CHECK((b.driven > 10) == drills);
    CHECK(std::abs(b.driven - b.report.dissipated[0].drilling) <= 1e-8 * (1 + b.driven));
    CHECK(std::abs(books(system, 1, options(Method::rk4, 1e-3)).difference) <= 1e-7);
    CHECK(std::abs(books(system, 1, options(Method::moreau_adaptive, 1e-3, 1e-6)).difference) <= 1e-4);
    check_order(system, 1, Method::moreau, 2e-3, 1.8, 2.2);
    check_order(system, 1, Method::rk4_printed, 2e-3, 0.8, 2.2);
    // Loads that depend on time alone, and M constant: exact.
    for (const Method method : {Method::moreau_implicit, Method::moreau_printed})
      CHECK(std::abs(books(system, 1, options(method, 2e-3)).difference) <= 1e-10);
  }
}

TEST_CASE("Energy: a driven body that hops", "[system][bodies]") {
  const RigidBodies system(hopper());
  CHECK(system.driven());
  const Books b = books(system, 2, options(Method::event_driven, 1e-3, tight));
  CHECK(b.report.events.size() > 5);
  CHECK(std::abs(b.driven) > 1);
  // Where slip is slow, an error of γ turns λ_T by so much more, and w̃ is not slow: λ_T·w̃ is less exact than
  // λ_T·γ, by w̃/γ.
  CHECK(std::abs(b.difference) <= 1e4 * tight);
  check_order(system, 2, Method::moreau_implicit, 1e-3, 0.8, 1.2);
}

TEST_CASE("Energy: a body told not to turn sticks and slides like a block", "[system][bodies]") {
  // With drilling friction that nothing moves against: a row of W that is zero.
  const RigidBodies driven(polisher(0, uniform_floor(0.3, 0.2)));
  CHECK(!driven.driven());
  BodiesData data = polisher(0, coulomb_floor(0.3));
  const RigidBodies block(data);
  const Books a = books(driven, 1, options(Method::event_driven, 1e-3, tight));
  const Books b = books(block, 1, options(Method::event_driven, 1e-3, tight));
  CHECK(a.report.events.size() == b.report.events.size());
  CHECK((a.end.q - b.end.q).norm() <= 1e-8);
  CHECK(std::abs(a.difference) <= 1e-8);
  CHECK(std::abs(books(driven, 1, options(Method::moreau, 1e-3)).difference) <= 1e-3);
}
