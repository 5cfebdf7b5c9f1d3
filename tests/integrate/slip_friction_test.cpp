#include "contensou/integrate/slip_friction.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace contensou;

namespace {

const AnyFriction none{NoFriction{}};
const AnyFriction disk{FrictionDisk{}};
const AnyFriction uniform{FrictionBall(SmoothPlate(UniformLaw{}))};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};

std::vector<Eigen::Vector3d> directions() {
  return {{1, 0, 0},        {0, -2, 0},   {0.3, -0.4, 0.2},  {-0.3, 0.1, 1},
          {1e-4, 2e-4, -1}, {1, 1, 1e-4}, {0.6, 0.8, 1.001}, {-0.6, 0.8, 0.999}};
}

}  // namespace

TEST_CASE("SlipFriction: dimensions", "[integrate]") {
  CHECK(SlipFriction(none).dimension() == 0);
  CHECK(SlipFriction(disk).dimension() == 2);
  CHECK(SlipFriction(hertz).dimension() == 3);
  CHECK(SlipFriction(none).border({1, 2, 3}) == Eigen::Vector3d::Zero());
  CHECK(SlipFriction(none).derivative({1, 2, 3}) == Eigen::Matrix3d::Zero());
}

TEST_CASE("SlipFriction: Coulomb's disk", "[integrate]") {
  const SlipFriction friction(disk);
  for (const double size : {1.0, 1e-9, 1e6}) {
    CHECK((friction.border(size * Eigen::Vector3d(3, -4, 7)) - Eigen::Vector3d(0.6, -0.8, 0)).norm() < 1e-15);
    // The direction turns by 1/v for a velocity across, and not at all for one along.
    const Eigen::Matrix3d d = size * friction.derivative(size * Eigen::Vector3d(3, -4, 7));
    CHECK((d * Eigen::Vector3d(0.6, -0.8, 0)).norm() < 1e-16);
    CHECK((d * Eigen::Vector3d(0.8, 0.6, 0) - Eigen::Vector3d(0.8, 0.6, 0) / 5).norm() < 1e-16);
    CHECK(d.col(2).norm() == 0);
    CHECK(d.row(2).norm() == 0);
  }
  CHECK(friction.gauge({3, -4, 100}) == Approx(5).epsilon(1e-15));
  CHECK((friction.normal({3, -4, 100}) - Eigen::Vector3d(0.6, -0.8, 0)).norm() < 1e-15);
  CHECK(!friction.border({0, 0, 1}).allFinite());
}

TEST_CASE("SlipFriction: the border is the law's force, at every speed", "[integrate]") {
  const auto check = [](const AnyFriction& friction, const auto& law) {
    const SlipFriction slip(friction);
    for (const Eigen::Vector3d& direction : directions()) {
      for (const double size : {1.0, 1e-9, 1e5}) {
        const Eigen::Vector3d gamma = size * direction;
        CAPTURE(gamma.transpose());
        const auto force = std::get<FrictionForce>(friction_force(law, {.mu = 0.5, .lambda_n = 4}, gamma));
        CHECK((2 * slip.border(gamma) + force).norm() < 4e-15);
        CHECK(slip.gauge(slip.border(gamma)) == Approx(1).epsilon(1e-12));  // it is on the border
      }
    }
    CHECK(!slip.border(Eigen::Vector3d::Zero()).allFinite());
    CHECK(!slip.border({INFINITY, 0, 0}).allFinite());
    CHECK_THROWS_AS(slip.derivative(Eigen::Vector3d::Zero()), std::domain_error);
  };
  check(hertz, HertzLaw{});
  check(uniform, UniformLaw{});
}

TEST_CASE("SlipFriction: derivative by central differences, at every speed", "[integrate]") {
  for (const AnyFriction* kind : {&disk, &uniform, &hertz}) {
    const SlipFriction slip(*kind);
    for (const Eigen::Vector3d& direction : directions()) {
      if (kind == &uniform && std::abs(direction.head<2>().norm() - std::abs(direction[2])) < 0.01)
        continue;  // its second derivatives have a logarithm at u = 1
      if (direction[0] == 0 || direction[1] == 0)
        continue;  // at ω = 0 the uniform and Hertz tails are one-sided
      for (const double size : {1.0, 1e-9}) {
        const Eigen::Vector3d gamma = size * direction;
        const double h = 1e-6 * size * std::abs(direction.cwiseAbs().minCoeff());
        const Eigen::Matrix3d d = slip.derivative(gamma);
        for (Eigen::Index k = 0; k < 3; ++k) {
          const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(k);
          const Eigen::Vector3d slope = (slip.border(gamma + step) - slip.border(gamma - step)) / (2 * h);
          CAPTURE(kind - &none, gamma.transpose(), k);
          // Rounding of the border over h, and h² of its third derivative over γ's smallest part.
          CHECK((slope - d.col(k)).norm() < 4e-16 / h + 1e-9 / size);
        }
      }
    }
  }
}

TEST_CASE("SlipFriction: normal and border are inverse to each other", "[integrate]") {
  for (const AnyFriction* kind : {&uniform, &hertz}) {
    const SlipFriction slip(*kind);
    for (const Eigen::Vector3d& direction : directions()) {
      const Eigen::Vector3d normal = slip.normal(3 * slip.border(direction));
      CAPTURE(direction.transpose());
      CHECK(normal.norm() == Approx(1).epsilon(1e-14));
      // The border's curvature is bounded from below but at the rim and the poles, where a rounding of the
      // point is worth its root.
      CHECK((normal - direction.normalized()).norm() < 1e-6);
    }
  }
}
