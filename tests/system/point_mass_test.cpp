#include "contensou/system/point_mass.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "differences.hpp"
#include "small_contacts.hpp"

using namespace contensou;
using namespace system_test;

namespace {

const PointMassData inclined{.m = 1.3, .g = 2, .tilt = 0.4, .force_x = 0.7, .force_y = -0.5};

}  // namespace

TEST_CASE("Point mass: its terms by differences", "[system]") {
  for (const SystemContact& contact : {smooth_floor(), coulomb_floor()}) {
    const PointMass mass(inclined, contact);
    check_terms(mass, generic_state(mass));
  }
}

TEST_CASE("Point mass: potential energy is height against gravity, less the work of the force", "[system]") {
  const PointMass mass(inclined, smooth_floor());
  const Eigen::Vector3d q(0.3, -0.8, 0.6);
  // the vertical in the plane's axes
  const Eigen::Vector3d up(-std::sin(0.4), 0, std::cos(0.4));
  CHECK(std::abs(mass.potential_energy(q) - (1.3 * 2 * up.dot(q) - 0.7 * 0.3 - 0.5 * 0.8)) <= 1e-15);
  Eigen::VectorXd h(3);
  mass.force(0, q, q, h);
  for (int k = 0; k < 3; ++k) {
    const double slope =
        rate([&](double t) { return mass.potential_energy(q + t * Eigen::Vector3d::Unit(k)); });
    CHECK(std::abs(h[k] + slope) <= difference_bound);
  }
}

TEST_CASE("Point mass: velocities of its contact", "[system]") {
  const PointMass mass({}, coulomb_floor());
  const Eigen::Vector3d q(1, 2, 3), u(4, 5, 6);
  ContactRows rows(3);
  mass.contact_rows(0, 0, q, u, rows);
  CHECK(mass.gap(0, 0, q) == 3);
  CHECK(rows.velocity[0] == 6);
  CHECK(rows.velocity[1] == 4);
  CHECK(rows.velocity[2] == 5);
}

TEST_CASE("Point mass: bad data give one clear line", "[system]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto says = [](const PointMassData& data, const std::string& message) {
    CHECK_THROWS_WITH(PointMass(data, coulomb_floor()), "point mass: " + message);
  };
  says({.m = 0}, "m 0, expected a number > 0");
  says({.m = nan}, "m nan, expected a number > 0");
  says({.g = -1}, "g -1, expected a number >= 0");
  says({.tilt = 2}, "tilt 2, expected a number from -pi/2 to pi/2");
  says({.force_x = nan}, "force_x nan, expected a finite number");
  says({.force_y = INFINITY}, "force_y inf, expected a finite number");
  CHECK_THROWS_WITH(PointMass({}, hertz_floor()),
                    "point mass: rows of its contact 4, expected 1 or 3: a point does not spin");
  CHECK_THROWS_WITH(PointMass({}, coulomb_floor(-1)), "contact floor: mu -1, expected a number >= 0");
}
