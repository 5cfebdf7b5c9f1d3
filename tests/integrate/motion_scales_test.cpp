#include "contensou/integrate/motion_scales.hpp"

#include <catch2/catch.hpp>

#include "contensou/system/ball_on_plane.hpp"
#include "contensou/system/point_mass.hpp"

using namespace contensou;

namespace {

const AnyFriction disk{FrictionDisk{}};

}  // namespace

TEST_CASE("MotionScales: from gravity, from the energy at hand, from nothing", "[integrate]") {
  const PointMass mass({.m = 3, .g = 4}, {"floor", disk, 0.5});
  const Eigen::Vector3d q(0, 0, 1);
  const MotionScales rest = motion_scales(mass, {0, q, Eigen::Vector3d::Zero()});
  CHECK(rest.length == 1);
  CHECK(rest.coordinate == Eigen::Vector3d::Ones());
  CHECK(rest.time == Approx(0.5).epsilon(1e-15));  // √(L/g)
  CHECK(rest.energy == Approx(6).epsilon(1e-15));  // ½m(gT)²
  CHECK(rest.speed == Approx(2).epsilon(1e-15));   // L/T
  CHECK((rest.velocity - Eigen::Vector3d::Constant(2)).norm() < 1e-14);

  const MotionScales fast = motion_scales(mass, {0, q, Eigen::Vector3d(0, -20, 0)});
  CHECK(fast.time == Approx(0.5).epsilon(1e-15));
  CHECK(fast.energy == Approx(600).epsilon(1e-15));
  CHECK(fast.speed == Approx(20).epsilon(1e-15));
  CHECK((fast.velocity - Eigen::Vector3d::Constant(20)).norm() < 1e-13);

  const PointMass still({.m = 3, .g = 0}, {"floor", disk, 0.5});
  const MotionScales none = motion_scales(still, {0, q, Eigen::Vector3d::Zero()});
  CHECK(none.time == 1);
  CHECK(none.energy == 1);
}

TEST_CASE("MotionScales: a change of units is a change of units", "[integrate]") {
  // In cm and g: lengths ×100, masses ×1000; of the ball all scales are of its own size.
  const auto ball = [](double length, double mass) {
    const BallOnPlane system({.m = 0.2 * mass, .r = 0.1 * length, .g = 9.81 * length}, {"floor", disk, 0.5});
    Eigen::VectorXd u(6);
    u << 1 * length, 2 * length, 0, 3, 4, 5;
    return motion_scales(system, {0, Eigen::Vector3d(0, 0, 0.1 * length), u});
  };
  const MotionScales si = ball(1, 1), cgs = ball(100, 1000);
  CHECK(si.length == 0.1);
  CHECK(cgs.time == Approx(si.time).epsilon(1e-14));
  CHECK(cgs.speed == Approx(100 * si.speed).epsilon(1e-14));
  CHECK(cgs.energy == Approx(1e7 * si.energy).epsilon(1e-14));
  CHECK(cgs.velocity[0] == Approx(100 * si.velocity[0]).epsilon(1e-14));
  CHECK(cgs.velocity[5] == Approx(si.velocity[5]).epsilon(1e-14));
}

TEST_CASE("MotionScales: slip speed counts the spin of a patch by the system's length", "[integrate]") {
  const AnyFriction ball{FrictionBall(SmoothPlate(HertzLaw{}))};
  CHECK(spin_factor({"a", ball, 0.3, 1e-3}, 0.2) == Approx(200).epsilon(1e-15));
  CHECK(spin_factor({"a", disk, 0.3}, 0.2) == 0);
  CHECK(slip_speed({9, 3, 4, 0.06}, 200) == Approx(13).epsilon(1e-15));
}
