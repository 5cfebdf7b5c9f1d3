#include "contensou/ball/friction_cylinder.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/rectangle_plate.hpp"

using namespace contensou;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

static_assert(FrictionDomain<FrictionCylinder>);

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
constexpr double eta = 2.0 / 3;
const FrictionCylinder cylinder(eta);

double number(std::mt19937_64& g) { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; }

/// Each component of another size, now and then zero.
Vector3d random_force(std::mt19937_64& g) {
  return Vector3d::NullaryExpr([&] { return number(g) < -0.8 ? 0 : number(g) * std::pow(10, number(g)); });
}

/// Extreme points of the cylinder of size 1, by which it is known: circles at both ends.
std::vector<Vector3d> extreme_points() {
  constexpr int count = 720;
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    for (const double end : {-eta, eta}) points.emplace_back(std::cos(angle), std::sin(angle), end);
  }
  return points;
}

}  // namespace

TEST_CASE("friction cylinder: its support function is the largest power", "[friction_cylinder]") {
  std::mt19937_64 g(1);
  const std::vector<Vector3d> points = extreme_points();
  for (int k = 0; k < 300; ++k) {
    const Vector3d gamma = random_force(g);
    const double size = 0.1 + std::abs(number(g));
    double power = 0;
    for (const Vector3d& x : points) power = std::max(power, size * x.dot(gamma));
    const double support = cylinder.support(size, gamma);
    CAPTURE(gamma.transpose(), size);
    CHECK(power <= support * (1 + 4 * eps));
    // The nearest of the points is half a spacing away: 1 − cos(π/720) < 1e-5.
    CHECK(power >= support * (1 - 1e-5));
  }
  CHECK(cylinder.support(2, {3, 4, -6}) == 2 * (5 + eta * 6));
}

TEST_CASE("friction cylinder: the projection is nearer than any other point", "[friction_cylinder]") {
  std::mt19937_64 g(2);
  const std::vector<Vector3d> points = extreme_points();
  for (int k = 0; k < 500; ++k) {
    const Vector3d force = random_force(g);
    const double size = k % 50 == 0 ? 0 : 0.1 + std::abs(number(g));
    const auto q = cylinder.project(force, size);
    const double scale = force.norm() + size;
    CAPTURE(force.transpose(), size);
    CHECK(q.inside == cylinder.contains(force, size));
    CHECK(cylinder.contains((1 - 4 * eps) * q.point, size));
    CHECK((force - q.point - q.distance * q.normal).norm() <= 8 * eps * scale);
    CHECK(q.inside == (q.distance == 0));
    // Onto a convex set: no point of it is on the other side of the plane through q.point.
    double beyond = 0;
    for (const Vector3d& x : points) beyond = std::max(beyond, q.normal.dot(size * x - q.point));
    CHECK(beyond <= 8 * eps * scale);
    if (q.inside) {
      CHECK(q.point == force);
    } else {
      CHECK(std::abs(q.normal.norm() - 1) <= 4 * eps);
    }
    const double gauge = cylinder.gauge(force);
    CHECK(cylinder.contains(force, gauge * (1 + 4 * eps)));
    CHECK((gauge == 0 || !cylinder.contains(force, gauge * (1 - 4 * eps))));
  }
}

TEST_CASE("friction cylinder: the ball of the rectangular plate is the same set", "[friction_cylinder]") {
  std::mt19937_64 g(3);
  const FrictionBall ball{RectanglePlate({.xi = 1, .eta = eta})};
  for (int k = 0; k < 500; ++k) {
    const Vector3d force = random_force(g);
    const double size = 0.1 + std::abs(number(g));
    const auto q = cylinder.project(force, size);
    const auto p = ball.project(force, size);
    const double scale = force.norm() + size;
    CAPTURE(force.transpose(), size);
    REQUIRE(q.inside == p.inside);
    CHECK((q.point - p.point).norm() <= 8 * eps * scale);
    CHECK(std::abs(q.distance - p.distance) <= 8 * eps * scale);
    CHECK(std::abs(cylinder.gauge(force) - ball.gauge(force)) <= 4 * eps * scale / eta);
    CHECK(std::abs(cylinder.support(size, force) - ball.support(size, force)) <= 8 * eps * scale * size);
    const auto d = cylinder.derivative(q, force, size);
    const auto e = ball.derivative(p, force, size);
    CHECK((d.force - e.force).norm() <= 16 * eps);
    CHECK((d.size - e.size).norm() <= 64 * eps * scale / size);
  }
}

TEST_CASE("friction cylinder: derivative of the projection, above each part of the border",
          "[friction_cylinder]") {
  constexpr double h = 1e-5;  // error: h² of third derivatives of order 1, rounding eps/h
  for (const Vector3d& force : {Vector3d(0.3, -0.2, 0.1), Vector3d(1.5, 2, 0.3), Vector3d(0.3, 0.4, -1.5),
                                Vector3d(-1.5, 2, 4), Vector3d(0, 0, 3)}) {
    constexpr double size = 1.25;
    const auto d = cylinder.derivative(cylinder.project(force, size), force, size);
    Matrix3d difference;
    for (int i = 0; i < 3; ++i) {
      const Vector3d e = h * Vector3d::Unit(i);
      difference.col(i) =
          (cylinder.project(force + e, size).point - cylinder.project(force - e, size).point) / (2 * h);
    }
    const Vector3d by_size =
        (cylinder.project(force, size + h).point - cylinder.project(force, size - h).point) / (2 * h);
    CAPTURE(force.transpose());
    CHECK((d.force - difference).cwiseAbs().maxCoeff() <= 1e-9);
    CHECK((d.size - by_size).cwiseAbs().maxCoeff() <= 1e-9);
    CHECK(d.force == d.force.transpose());
  }
}

TEST_CASE("friction cylinder: the ends of the range", "[friction_cylinder]") {
  const auto far = cylinder.project({1.5e308, 1.5e308, -1.7e308}, 1);
  CHECK_FALSE(far.inside);
  CHECK((far.point - Vector3d(std::numbers::sqrt2 / 2, std::numbers::sqrt2 / 2, -eta)).norm() <= 4 * eps);
  CHECK(std::isfinite(far.distance));
  CHECK(std::abs(far.normal.norm() - 1) <= 4 * eps);
  const auto near = cylinder.project({smallest, smallest, 0}, smallest);
  CHECK_FALSE(near.inside);
  CHECK(std::abs(near.normal.norm() - 1) <= 4 * eps);
  CHECK(cylinder.contains({0, 0, 0}, 0));
  CHECK(cylinder.project({0, 0, 0}, 0).inside);
  CHECK(cylinder.project({1e308, 0, 0}, largest).inside);
}

TEST_CASE("friction cylinder: what is not a number or not a size", "[friction_cylinder]") {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(FrictionCylinder(bad), std::invalid_argument);
  }
  const Vector3d one(1, 1, 1);
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(cylinder.support(bad, one), std::invalid_argument);
    CHECK_THROWS_AS(cylinder.contains(one, bad), std::invalid_argument);
    CHECK_THROWS_AS(cylinder.project(one, bad), std::invalid_argument);
  }
  for (int i = 0; i < 3; ++i) {
    Vector3d x = one;
    x[i] = std::nan("");
    CHECK_THROWS_AS(cylinder.support(1, x), std::domain_error);
    CHECK_THROWS_AS(cylinder.gauge(x), std::domain_error);
    CHECK_THROWS_AS(cylinder.contains(x, 1), std::domain_error);
    CHECK_THROWS_AS(cylinder.project(x, 1), std::domain_error);
  }
}
