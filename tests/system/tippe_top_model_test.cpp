#include "contensou/system/tippe_top_model.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"
#include "differences.hpp"
#include "tippe_top_states.hpp"

using namespace contensou;
using namespace system_test;

TEST_CASE("Tippe-top: the data of LG03 5.4 are the defaults", "[system]") {
  const TippeTopAxis top({}, tippe_top_contacts(hertz));
  CHECK(top.data().m == 6e-3);
  CHECK(top.data().i1 == 8e-7);
  CHECK(top.data().i3 == 7e-7);
  CHECK(top.data().a2 == 1.6e-2);
  REQUIRE(top.contacts().size() == 2);
  CHECK(top.contacts()[0].name == "body");
  CHECK(top.contacts()[1].name == "tip");
  CHECK(top.contacts()[1].mu == 0.3);
  CHECK(top.contacts()[1].radius == 5e-4);
  CHECK(top.contacts()[1].restitution == 0);
  CHECK(top.length_scale() == 2.1e-2);
}

TEST_CASE("Tippe-top: starts touching to the last bit", "[system]") {
  const TippeTopAxis axis({}, tippe_top_contacts(hertz));
  const TippeTopEuler euler({}, tippe_top_contacts(hertz));
  for (const TippeTopModel* top :
       {static_cast<const TippeTopModel*>(&axis), static_cast<const TippeTopModel*>(&euler)}) {
    int exact = 0;
    for (int i = 1; i < 1000; ++i) {
      const double theta = std::numbers::pi * i / 1000;
      State s = top->start(theta, 180);
      top->restore(s.q);
      const double body = top->gap(0, 0, s.q);
      const double tip = top->gap(1, 0, s.q);
      if (std::min(body, tip) == 0) ++exact;
      CHECK(std::abs(top->inclination(s.q) - theta) <= 1e-15);
      CHECK(top->height(s.q) == s.q[2]);
      // ω = ψ̇e, and so turned by the floor's first axis
      CHECK((top->spin(s.q, s.u) - 180 * Eigen::Vector3d(0, -std::sin(theta), std::cos(theta))).norm() <=
            1e-13);
    }
    CHECK(exact == 999);
    CHECK(top->start(0.1, 180, 1.2015e-2).q[2] == 1.2015e-2);
  }
  // upright and inverted, where only one of the two can stand
  CHECK(axis.gap(0, 0, axis.start(0, 180).q) == 0);
  CHECK(axis.gap(1, 0, axis.start(std::numbers::pi, 180).q) == 0);
}

TEST_CASE("Tippe-top: both formulations say the same of one physical state", "[system]") {
  const TippeTopAxis axis(solid, tippe_top_contacts(hertz, 0.3, 0.4));
  const TippeTopEuler euler(solid, tippe_top_contacts(hertz, 0.3, 0.4));
  for (const State& e : euler_states()) {
    const State a = axis_state(euler, e);
    CHECK(std::abs(axis.kinetic_energy(a.q, a.u) - euler.kinetic_energy(e.q, e.u)) <= 1e-13);
    CHECK(axis.potential_energy(a.q) == euler.potential_energy(e.q));
    CHECK(std::abs(axis.inclination(a.q) - euler.inclination(e.q)) <= 1e-14);

    Eigen::VectorXd free_a(6);
    Eigen::VectorXd free_e(6);
    axis.free_acceleration(0, a.q, a.u, free_a);
    euler.free_acceleration(0, e.q, e.u, free_e);
    for (const std::size_t i : {0, 1}) {
      ContactRows rows_a(6);
      ContactRows rows_e(6);
      axis.contact_rows(i, 0, a.q, a.u, rows_a);
      euler.contact_rows(i, 0, e.q, e.u, rows_e);
      CHECK(std::abs(axis.gap(i, 0, a.q) - euler.gap(i, 0, e.q)) <= 1e-15);
      CHECK((rows_a.velocity - rows_e.velocity).norm() <= 1e-13);
      // Δv, Δω by a unit impulse in each row; Delassus' matrix
      for (int k = 0; k < 4; ++k) {
        const Eigen::VectorXd jump = rows_e.response.col(k);
        CHECK((rows_a.response.col(k).head<3>() - jump.head<3>()).norm() <= 1e-13);
        CHECK((rows_a.response.col(k).tail<3>() - euler.spin(e.q, jump)).norm() <= 1e-13);
      }
      const Eigen::Matrix4d delassus = rows_a.directions.transpose() * rows_a.response;
      CHECK((delassus - rows_e.directions.transpose() * rows_e.response).norm() <= 1e-13);
      // γ̇ in free flight: the drifts differ, since u̇ = 0 means another motion
      const Eigen::Vector4d change = rows_a.drift + rows_a.directions.transpose() * free_a;
      CHECK((change - rows_e.drift - rows_e.directions.transpose() * free_e).norm() <= 1e-12);

      // Physical accelerations with a force at the contact, ω̇ by differences
      const Eigen::Vector4d force(2, -0.7, 0.4, 0.9);
      const Eigen::VectorXd total_a = free_a + rows_a.response * force;
      const Eigen::VectorXd total_e = free_e + rows_e.response * force;
      CHECK((total_a.head<3>() - total_e.head<3>()).norm() <= 1e-13);
      const Eigen::Vector3d turning = rate([&](double t) -> Eigen::Vector3d {
        const State later = moved(euler, e, total_e, t);
        return euler.spin(later.q, later.u);
      });
      CHECK((total_a.tail<3>() - turning).norm() <= difference_bound * (1 + turning.norm()));
    }
  }
}

TEST_CASE("Tippe-top: bad data give one clear line", "[system]") {
  const auto contacts = tippe_top_contacts(hertz);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto says = [&](const TippeTopData& data, const std::string& message) {
    CHECK_THROWS_WITH(TippeTopAxis(data, contacts), "tippe-top: " + message);
    CHECK_THROWS_WITH(TippeTopEuler(data, contacts), "tippe-top: " + message);
  };
  says({.m = 0}, "m 0, expected a number > 0");
  says({.m = nan}, "m nan, expected a number > 0");
  says({.i1 = -1e-7}, "i1 -1e-07, expected a number > 0");
  says({.i3 = 1.7e-6}, "i3 1.7e-06, expected a number > 0, at most 2 i1");
  says({.g = -9.81}, "g -9.81, expected a number >= 0");
  says({.a1 = infinity}, "a1 inf, expected a finite number");
  says({.a2 = nan}, "a2 nan, expected a finite number");
  says({.r1 = 0}, "r1 0, expected a number > 0");
  says({.r2 = infinity}, "r2 inf, expected a number > 0");

  CHECK_THROWS_WITH(TippeTopAxis({}, {contacts[1], contacts[0]}), "tippe-top: contact tip, expected body");
  CHECK_THROWS_WITH(TippeTopAxis({}, tippe_top_contacts(hertz, -0.1)),
                    "contact body: mu -0.1, expected a number >= 0");

  const TippeTopAxis top({}, contacts);
  CHECK_THROWS_WITH(top.start(-0.1, 180), "tippe-top: theta -0.1, expected a number from 0 to pi");
  CHECK_THROWS_WITH(top.start(3.2, 180), "tippe-top: theta 3.2, expected a number from 0 to pi");
  CHECK_THROWS_WITH(top.start(nan, 180), "tippe-top: theta nan, expected a number from 0 to pi");
  CHECK_THROWS_WITH(top.start(0.1, infinity), "tippe-top: psi_dot inf, expected a finite number");
  CHECK_THROWS_WITH(top.start(0.1, 180, nan), "tippe-top: z_s nan, expected a finite number");
  CHECK_THROWS_WITH(TippeTopEuler({}, contacts).start(0, 180),
                    "tippe-top: theta 0, expected one between 0 and pi: Euler angles are singular there");
}
