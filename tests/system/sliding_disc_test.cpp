#include "contensou/system/sliding_disc.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "differences.hpp"
#include "small_contacts.hpp"

using namespace contensou;
using namespace system_test;

TEST_CASE("Sliding disc: its terms by differences", "[system]") {
  for (const SystemContact& contact : {smooth_floor(), coulomb_floor(), hertz_floor()}) {
    const SlidingDisc disc({.m = 1.3, .i = 0.6, .g = 2}, contact);
    check_terms(disc, generic_state(disc));
    CHECK(std::abs(disc.length_scale() - std::sqrt(0.6 / 1.3)) <= 1e-15);
    Eigen::VectorXd scales(4);
    disc.coordinate_scales(scales);
    CHECK(scales[0] == disc.length_scale());
    CHECK(scales[3] == 1);
  }
}

TEST_CASE("Sliding disc: velocities of its contact", "[system]") {
  const SlidingDisc disc({}, hertz_floor(0.3, 0.5));
  const Eigen::Vector4d q(1, 2, 3, 4), u(5, 6, 7, 8);
  ContactRows rows(4);
  disc.contact_rows(0, 0, q, u, rows);
  CHECK(disc.gap(0, 0, q) == 3);
  CHECK(rows.velocity == Eigen::Vector4d(7, 5, 6, 4));
  CHECK(disc.potential_energy(q) == 9.81 * 3);
}

TEST_CASE("Sliding disc: bad data give one clear line", "[system]") {
  const auto says = [](const SlidingDiscData& data, const std::string& message) {
    CHECK_THROWS_WITH(SlidingDisc(data, hertz_floor()), "sliding disc: " + message);
  };
  says({.m = 0}, "m 0, expected a number > 0");
  says({.i = -1}, "i -1, expected a number > 0");
  says({.g = NAN}, "g nan, expected a number >= 0");
  CHECK_THROWS_WITH(SlidingDisc({}, hertz_floor(0.3, 0)), "contact floor: radius 0, expected a number > 0");
}
