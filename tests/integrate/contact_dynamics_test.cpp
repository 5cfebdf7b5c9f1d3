#include "contensou/integrate/contact_dynamics.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "../system/tippe_top_states.hpp"
#include "contensou/contact/acceleration_level.hpp"
#include "contensou/contact/contact_solver.hpp"
#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/sliding_disc.hpp"

using namespace contensou;

namespace {

constexpr auto open = ContactMode::open;
constexpr auto slip = ContactMode::slip;
constexpr auto stick = ContactMode::stick;
const AnyFriction frictionless{NoFriction{}};
const AnyFriction& disk = system_test::point;
const AnyFriction& hertz = system_test::hertz;

/// A state of a system, generic but that its contacts need not be closed: what is checked is linear algebra.
struct Case {
  std::shared_ptr<const MechanicalSystem> system;
  State state;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const AnyFriction* friction : {&frictionless, &disk, &hertz}) {
    all.push_back({std::make_shared<BallOnPlane>(BallOnPlaneData{.m = 2, .r = 0.5, .tilt = 0.1},
                                                 SystemContact{"floor", *friction, 0.3, 0.05}),
                   {0, Eigen::Vector3d(0.1, 0.2, 0.5), Eigen::VectorXd{{1, -2, 0.3, 2, 0.5, -1}}}});
    all.push_back(
        {std::make_shared<SlidingDisc>(SlidingDiscData{}, SystemContact{"floor", *friction, 0.4, 0.7}),
         {0, Eigen::Vector4d(0.1, 0.2, 0, 1), Eigen::Vector4d(1, -2, 0.3, 2)}});
    for (const State& s : system_test::euler_states()) {
      const auto contacts = tippe_top_contacts(*friction, 0.2, 0.05);
      const auto euler = std::make_shared<TippeTopEuler>(system_test::solid, contacts);
      all.push_back({euler, s});
      all.push_back(
          {std::make_shared<TippeTopAxis>(system_test::solid, contacts), system_test::axis_state(*euler, s)});
    }
  }
  return all;
}

/// All there are; a frictionless contact that is closed `slips`. Two contacts that stick are a special case:
/// their constraints depend on each other and are met by special states only.
std::vector<std::vector<ContactMode>> modes_of(const MechanicalSystem& system) {
  std::vector<ContactMode> one{open, slip};
  if (rows(system.contacts()[0].friction) > 1) one.push_back(stick);
  std::vector<std::vector<ContactMode>> all;
  for (const ContactMode a : one) {
    if (system.contacts().size() == 1) {
      all.push_back({a});
      continue;
    }
    for (const ContactMode b : one) {
      if (a != stick || b != stick) all.push_back({a, b});
    }
  }
  return all;
}

Eigen::VectorXd vector(const ContactDynamics& dynamics, const State& state) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(dynamics.size());
  y << state.q, state.u, Eigen::VectorXd::Zero(2 * Eigen::Index(dynamics.contacts()));
  return y;
}

Eigen::VectorXd rate_of(ContactDynamics& dynamics, const State& state) {
  Eigen::VectorXd dy(dynamics.size());
  dynamics.derivative(state.t, vector(dynamics, state), dy);
  return dy;
}

/// −x̂(γ_F) of the friction that a contact has, from the law.
Eigen::Vector3d unit_force(const AnyFriction& friction, const Eigen::Vector3d& gamma) {
  if (rows(friction) == 1) return Eigen::Vector3d::Zero();
  if (rows(friction) == 3) {
    const double v = gamma.head<2>().norm();
    return {-gamma[0] / v, -gamma[1] / v, 0};
  }
  return std::get<FrictionForce>(friction_force(HertzLaw{}, {1, 1}, gamma));
}

/// An upright sliding disc with a velocity of the size given, in all friction directions.
State sliding(double size) { return {0, Eigen::Vector4d::Zero(), size * Eigen::Vector4d(0.6, -0.8, 0, 0.9)}; }

}  // namespace

TEST_CASE("ContactDynamics: equations of motion, constraints, law and power in all modes", "[integrate]") {
  for (const Case& c : cases()) {
    const MechanicalSystem& system = *c.system;
    ContactDynamics dynamics(system);
    const Eigen::Index n = system.coordinates(), f = system.velocities();
    Eigen::MatrixXd mass(f, f);
    system.mass_matrix(c.state.q, mass);
    for (const auto& modes : modes_of(system)) {
      dynamics.set_modes(modes);
      const Eigen::VectorXd dy = rate_of(dynamics, c.state);
      REQUIRE(dy.allFinite());
      CAPTURE(rows(system.contacts()[0].friction), f, int(modes[0]), int(modes.back()));

      Eigen::VectorXd rates(n), left(f);
      system.coordinate_rates(c.state.q, c.state.u, rates);
      CHECK(dy.head(n) == rates);
      // Mu̇ − h − Wλ = 0, with forces of size 1 to 100 and the rounding of systems of up to 8 of them, whose
      // condition (arms to radius of the patch, squared) is some thousands.
      system.force(c.state.t, c.state.q, c.state.u, left);
      left = mass * dy.segment(n, f) - left;
      double largest = 1;
      for (std::size_t i = 0; i < modes.size(); ++i) {
        const std::size_t count = std::size_t(rows(system.contacts()[i].friction));
        ContactRows rows(f);
        system.contact_rows(i, c.state.t, c.state.q, c.state.u, rows);
        const Eigen::Vector4d lambda = dynamics.force(i);
        largest = std::max(largest, lambda.norm());
        if (modes[i] == open) CHECK(lambda.norm() == 0);
        for (std::size_t k = 0; k < count; ++k)
          left -= lambda[Eigen::Index(k)] * rows.directions.col(Eigen::Index(k));
      }
      const double accuracy = 1e-12 * largest;
      CHECK(left.norm() < accuracy);

      for (std::size_t i = 0; i < modes.size(); ++i) {
        const SystemContact& contact = system.contacts()[i];
        const Eigen::Index count = rows(contact.friction), at = n + f + 2 * Eigen::Index(i);
        const Eigen::Vector4d lambda = dynamics.force(i);
        ContactRows rows(f);
        system.contact_rows(i, c.state.t, c.state.q, c.state.u, rows);
        Eigen::Vector4d acceleration = Eigen::Vector4d::Zero();
        for (Eigen::Index k = 0; k < count; ++k)
          acceleration[k] = rows.directions.col(k).dot(dy.segment(n, f)) + rows.drift[k];
        if (modes[i] == open) continue;
        CHECK(std::abs(acceleration[0]) < accuracy);
        CHECK((dynamics.contact_acceleration(i, dy) - acceleration).norm() < accuracy);
        if (modes[i] == stick) {
          CHECK(acceleration.norm() < accuracy);
          CHECK(dy[at] == 0);
          CHECK(dy[at + 1] == 0);
        } else {
          const Eigen::Vector3d gamma = rows.velocity.tail<3>();
          const Eigen::Vector3d expected = contact.mu * lambda[0] * unit_force(contact.friction, gamma);
          CHECK((lambda.tail<3>() - expected).norm() < accuracy);
          CHECK(std::abs(dy[at] + (count > 1 ? lambda.segment<2>(1).dot(gamma.head<2>()) : 0)) < accuracy);
          CHECK(std::abs(dy[at + 1] + (count > 3 ? lambda[3] * gamma[2] : 0)) < accuracy);
        }
      }
    }
  }
}

TEST_CASE("ContactDynamics: agrees with the inclusion on acceleration level where that stays closed",
          "[integrate]") {
  int compared = 0;
  for (const Case& c : cases()) {
    const MechanicalSystem& system = *c.system;
    const Eigen::Index f = system.velocities();
    ContactDynamics dynamics(system);
    Eigen::VectorXd free(f);
    system.free_acceleration(c.state.t, c.state.q, c.state.u, free);
    for (const auto& modes : modes_of(system)) {
      ContactProblem full;
      std::vector<std::size_t> closed;
      Eigen::MatrixXd directions(f, 0), response(f, 0);
      Eigen::VectorXd velocity(0), drift(0);
      for (std::size_t i = 0; i < modes.size(); ++i) {
        if (modes[i] == open) continue;
        closed.push_back(i);
        const SystemContact& contact = system.contacts()[i];
        const Eigen::Index count = rows(contact.friction), m = velocity.size();
        full.groups.push_back({&contact.friction, {contact.mu}});
        ContactRows rows(f);
        system.contact_rows(i, c.state.t, c.state.q, c.state.u, rows);
        directions.conservativeResize(f, m + count);
        response.conservativeResize(f, m + count);
        velocity.conservativeResize(m + count);
        drift.conservativeResize(m + count);
        directions.rightCols(count) = rows.directions.leftCols(count);
        response.rightCols(count) = rows.response.leftCols(count);
        velocity.tail(count).setZero();
        if (modes[i] == slip) velocity.tail(count) = rows.velocity.head(count);
        drift.tail(count) = rows.drift.head(count);
      }
      if (closed.empty()) continue;
      full.delassus = directions.transpose() * response;
      full.delassus = (full.delassus + full.delassus.transpose()).eval() / 2;
      full.free_velocity = directions.transpose() * free + drift;
      const AccelerationLevel level(full, velocity);
      ContactSolver solver;
      Eigen::VectorXd reduced;
      if (solver.solve(level.problem(), reduced).status != SolverStatus::solved) continue;
      const Eigen::VectorXd forces = level.forces(reduced);

      dynamics.set_modes(modes);
      const Eigen::VectorXd dy = rate_of(dynamics, c.state);
      // The same inclusion only if contacts press and those that stick can.
      bool admissible = true;
      for (const std::size_t i : closed) {
        const Eigen::Vector4d& lambda = dynamics.force(i);
        admissible = admissible && lambda[0] > 0;
        if (modes[i] == stick)
          admissible = admissible &&
                       dynamics.friction(i).gauge(lambda.tail<3>()) < system.contacts()[i].mu * lambda[0];
      }
      if (!admissible) continue;
      ++compared;
      const Eigen::VectorXd a = free + response * forces;
      CAPTURE(rows(system.contacts()[0].friction), f, int(modes[0]), int(modes.back()));
      // The solver's tolerance is 1e-12 of the largest |b|.
      const double accuracy = 1e-10 * std::max(1.0, a.norm());
      CHECK((a - dy.segment(system.coordinates(), f)).norm() < accuracy);
    }
  }
  CHECK(compared > 30);
}

TEST_CASE("ContactDynamics: the Jacobian is exact, however slow the slip", "[integrate]") {
  const auto check = [](const MechanicalSystem& system, const State& state,
                        const std::vector<ContactMode>& modes, double slowest) {
    ContactDynamics dynamics(system);
    dynamics.set_modes(modes);
    const Eigen::VectorXd y = vector(dynamics, state), rate = rate_of(dynamics, state);
    CAPTURE(int(modes[0]), int(modes.back()), rows(system.contacts()[0].friction), rate.transpose());
    REQUIRE(rate.allFinite());
    Eigen::MatrixXd jacobian(dynamics.size(), dynamics.coupled());
    dynamics.jacobian(state.t, y, rate, jacobian);
    for (Eigen::Index j = 0; j < dynamics.coupled(); ++j) {
      // Central differences of a hundred-thousandth of what slips slowest: h² of the curvature is 1e-10.
      const double h = 1e-5 * slowest;
      Eigen::VectorXd moved = y, up(y.size()), down(y.size());
      moved[j] = y[j] + h;
      const double right = moved[j];
      dynamics.derivative(state.t, moved, up);
      moved[j] = y[j] - h;
      dynamics.derivative(state.t, moved, down);
      const Eigen::VectorXd slope = (up - down) / (right - moved[j]);
      CAPTURE(j, slope.transpose(), jacobian.col(j).transpose());
      const double rounding = 1e-14 * (1 + rate.norm()) / h;
      CHECK((slope - jacobian.col(j)).norm() < 1e-6 * (1 + jacobian.norm()) + rounding);
    }
  };
  for (const AnyFriction* friction : {&frictionless, &disk, &hertz}) {
    const SlidingDisc disc({}, {"floor", *friction, 0.4, 0.7});
    for (const double size : {1.0, 1e-3, 1e-9}) {
      CAPTURE(size);
      check(disc, sliding(size), {slip}, size);
    }
    const TippeTopAxis top(system_test::solid, tippe_top_contacts(*friction, 0.2, 0.05));
    const TippeTopEuler euler(system_test::solid, tippe_top_contacts(*friction, 0.2, 0.05));
    const State s = system_test::euler_states()[0];
    for (const auto& modes : modes_of(top)) {
      check(euler, s, modes, 0.1);
      check(top, system_test::axis_state(euler, s), modes, 0.1);
    }
  }
}

TEST_CASE("ContactDynamics: two contacts that stick, their constraints depending on each other",
          "[integrate]") {
  // Body and tip on the floor, a sphere each, roll like a cone: ω along the line of the contact points. Of
  // their six (eight) constraints five are independent.
  for (const AnyFriction* friction : {&disk, &hertz}) {
    const TippeTopAxis top(system_test::solid, tippe_top_contacts(*friction, 0.2, 0.05));
    const TippeTopData& d = top.data();
    const double cosine = (d.r1 - d.r2) / (d.a1 - d.a2), theta = std::acos(cosine);  // both gaps zero
    for (const double omega : {0.0, 3.0}) {
      State state = top.start(theta, 0);
      REQUIRE(std::abs(top.gap(0, 0, state.q)) < 1e-15);
      REQUIRE(std::abs(top.gap(1, 0, state.q)) < 1e-15);
      const Eigen::Vector3d e = state.q.tail<3>(), up(0, 0, 1);
      const Eigen::Vector3d spin = omega * (e - cosine * up).normalized();
      state.u << -spin.cross(d.a1 * e - d.r1 * up), spin;  // the contact point of the body is at rest
      ContactDynamics dynamics(top);
      dynamics.set_modes({stick, stick});
      const Eigen::VectorXd dy = rate_of(dynamics, state);
      REQUIRE(dy.allFinite());
      const Eigen::Vector4d body = dynamics.force(0), tip = dynamics.force(1);
      Eigen::VectorXd left(6);
      Eigen::MatrixXd mass(6, 6);
      top.mass_matrix(state.q, mass);
      top.force(0, state.q, state.u, left);
      left -= mass * dy.segment(6, 6);
      for (const std::size_t i : {0, 1}) {
        const Eigen::Index count = 1 + dynamics.friction(i).dimension();
        CAPTURE(count, omega, i, dynamics.rows(i).velocity.transpose());
        CHECK(dynamics.rows(i).velocity.head(count).norm() < 1e-14);  // it does stick
        CHECK(dynamics.contact_acceleration(i, dy).norm() < 1e-11);
        left += dynamics.rows(i).directions.leftCols(count) * dynamics.force(i).head(count);
      }
      CHECK(left.norm() < 1e-11);
      CHECK(body[0] + tip[0] == Approx(d.m * d.g).epsilon(1e-11));  // the centre stays at its height
      if (omega > 0) continue;
      // At rest: a beam on two supports, without friction.
      CHECK(dy.norm() < 1e-11);
      CHECK(tip[0] * d.a2 == Approx(-body[0] * d.a1).epsilon(1e-11));
      CHECK(body.tail<3>().norm() < 1e-11);
      CHECK(tip.tail<3>().norm() < 1e-11);
    }
  }
}

TEST_CASE("ContactDynamics: a disc without patch, patches of any size", "[integrate]") {
  // A frictionless and a μ = 0 contact are the same.
  const SlidingDisc none({}, {"floor", frictionless}), zero({}, {"floor", hertz, 0, 0.7});
  for (const SlidingDisc* disc : {&none, &zero}) {
    ContactDynamics dynamics(*disc);
    dynamics.set_modes({slip});
    const Eigen::VectorXd dy = rate_of(dynamics, sliding(1));
    CHECK(dynamics.friction(0).dimension() == 0);
    CHECK(dy.segment(4, 4).norm() == 0);
    CHECK(dynamics.relaxation_rate() == 0);
  }
  for (const double radius : {1e-9, 1.0, 1e3}) {
    const SlidingDisc disc({}, {"floor", hertz, 0.4, radius});
    ContactDynamics dynamics(disc);
    dynamics.set_modes({stick});
    const Eigen::VectorXd dy = rate_of(dynamics, sliding(0));
    CAPTURE(radius);
    CHECK(dy.allFinite());
    CHECK(dy.segment(4, 4).norm() < 1e-14);
    CHECK(dynamics.force(0)[0] == Approx(9.81).epsilon(1e-14));
    CHECK(dynamics.force(0).tail<3>().norm() < 1e-14);
  }
}

TEST_CASE("ContactDynamics: the relaxation rate bounds that of the friction, and not by much",
          "[integrate]") {
  for (const AnyFriction* friction : {&disk, &hertz}) {
    for (const double size : {1.0, 1e-6}) {
      const SlidingDisc disc({}, {"floor", *friction, 0.4, 0.7});
      ContactDynamics dynamics(disc);
      dynamics.set_modes({slip});
      const State state = sliding(size);
      const Eigen::VectorXd rate = rate_of(dynamics, state);
      const double bound = dynamics.relaxation_rate();
      Eigen::MatrixXd jacobian(dynamics.size(), dynamics.coupled());
      dynamics.jacobian(0, vector(dynamics, state), rate, jacobian);
      const Eigen::MatrixXd velocities = jacobian.block(4, 4, 4, 4);
      const double radius = velocities.eigenvalues().cwiseAbs().maxCoeff();
      CAPTURE(size, bound, radius);
      CHECK(bound >= radius * (1 - 1e-6));
      CHECK(bound <= 3 * radius);  // the trace of three eigenvalues that are not negative
    }
  }
  // A top that slips: the rate of the stiff part alone, at a slip so slow that all else is nothing.
  const TippeTopAxis top(system_test::solid, tippe_top_contacts(disk, 0.2));
  State state = top.start(0.5, 0);
  state.u[0] = 1e-7;
  ContactDynamics dynamics(top);
  dynamics.set_modes({slip, open});
  const Eigen::VectorXd rate = rate_of(dynamics, state);
  const double bound = dynamics.relaxation_rate();
  Eigen::MatrixXd jacobian(dynamics.size(), dynamics.coupled());
  dynamics.jacobian(0, vector(dynamics, state), rate, jacobian);
  const double radius = jacobian.topRows(12).eigenvalues().cwiseAbs().maxCoeff();
  CAPTURE(bound, radius);
  CHECK(bound >= radius * (1 - 1e-4));
  CHECK(bound <= 3 * radius);
}

TEST_CASE("ContactDynamics: evaluations are counted, quadratures follow", "[integrate]") {
  const SlidingDisc disc({}, {"floor", hertz, 0.4, 0.7});
  ContactDynamics dynamics(disc);
  CHECK(dynamics.size() == 10);
  CHECK(dynamics.coupled() == 8);
  dynamics.set_modes({slip});
  rate_of(dynamics, sliding(1));
  rate_of(dynamics, sliding(1));
  CHECK(dynamics.evaluations() == 2);
  // At rest a slipping contact has no force.
  CHECK(!rate_of(dynamics, sliding(0)).allFinite());
}
