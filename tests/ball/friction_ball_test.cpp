#include "contensou/ball/friction_ball.hpp"

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "contensou/ball/disk_plate.hpp"
#include "contensou/ball/friction_disk.hpp"
#include "contensou/ball/smooth_plate.hpp"

using namespace contensou;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

const FrictionBall uniform_ball{SmoothPlate(UniformLaw{})};
const FrictionBall hertz_ball{SmoothPlate(HertzLaw{})};

const std::vector<double> speed_ratios{0, 1e-200, 1e-8, 0.3, 0.9, 1 - eps, 1, 1 + eps, 1.2, 4, 1e7, 1e200};

/// A unit vector with ‖n_T‖/|n_τ| = u.
Eigen::Vector3d unit_normal(double u) {
  const Eigen::Vector3d direction =
      u <= 1 ? Eigen::Vector3d(0.6 * u, -0.8 * u, 1) : Eigen::Vector3d(0.6, -0.8, 1 / u);
  return direction.normalized();
}

template <class Ball>
void check_projects_back(const Ball& ball) {
  for (const double u : speed_ratios) {
    const Eigen::Vector3d n = unit_normal(u);
    for (const double size : {1e-9, 1.0, 3e7}) {
      const FrictionForce border = ball.boundary_point(size, n);
      for (const double distance : {1e-12, 1e-3, 1.0, 1e9}) {
        const FrictionForce p = border + distance * size * n;
        const auto q = ball.project(p, size);
        INFO("u " << u << ", size " << size << ", distance " << distance);
        // 4 of the projection, 4 of the law and the rounding of p.
        const double bound = 9 * eps * std::max(p.norm(), size);
        CHECK((q.point - border).norm() <= bound);
        CHECK(std::abs(q.distance - distance * size) <= bound);
        CHECK_FALSE(q.inside);
        CHECK((p - q.point - q.distance * q.normal).norm() <= 4 * eps * std::max(p.norm(), size));
      }
      CHECK(std::abs(ball.gauge(border) - size) <= 8 * eps * size);
      CHECK(ball.on_boundary(border, size));
      CHECK_FALSE(ball.on_boundary(1.001 * border, size));
      CHECK(ball.contains(0.999 * border, size));
      CHECK_FALSE(ball.contains(1.001 * border, size));
    }
  }
}

/// Against central differences with the step h: error below `bound`.
template <class Ball>
void check_derivative(const Ball& ball, const FrictionForce& p, double size, double h, double bound) {
  const auto q = ball.project(p, size);
  const auto d = ball.derivative(q, p, size);
  Eigen::Matrix3d difference;
  for (int i = 0; i < 3; ++i) {
    const FrictionForce step = h * FrictionForce::Unit(i);
    difference.col(i) = (ball.project(p + step, size).point - ball.project(p - step, size).point) / (2 * h);
  }
  INFO("force " << p.transpose());
  CHECK((d.force - difference).cwiseAbs().maxCoeff() <= bound);
  const Eigen::Vector3d by_size =
      (ball.project(p, size + h).point - ball.project(p, size - h).point) / (2 * h);
  CHECK((d.size - by_size).cwiseAbs().maxCoeff() <= bound);
}

}  // namespace

TEST_CASE("friction ball: a point above the border projects back onto it", "[friction_ball]") {
  check_projects_back(uniform_ball);
  check_projects_back(hertz_ball);
}

TEST_CASE("friction ball: on the axis and in the plane", "[friction_ball]") {
  const double height = 3 * std::numbers::pi / 16;
  const auto above = hertz_ball.project({0, 0, -5}, 2);
  CHECK((above.point - FrictionForce(0, 0, -2 * height)).norm() <= 4 * eps);
  CHECK(above.normal == Eigen::Vector3d(0, 0, -1));
  const auto beside = hertz_ball.project({0, 5, 0}, 2);
  CHECK((beside.point - FrictionForce(0, 2, 0)).norm() <= 4 * eps);
  CHECK(beside.normal == Eigen::Vector3d(0, 1, 0));
  CHECK(std::abs(hertz_ball.support(2, {0, 0, -3}) - 6 * height) <= 8 * eps);
  CHECK(hertz_ball.support(2, {0, 0, 0}) == 0);
}

TEST_CASE("friction ball: inside, nothing moves", "[friction_ball]") {
  for (const FrictionForce& p :
       {FrictionForce(0, 0, 0), FrictionForce(0.1, -0.2, 0.3), FrictionForce(0.9, 0, 0.1)}) {
    const auto q = uniform_ball.project(p, 1);
    CHECK(q.inside);
    CHECK(q.point == p);
    CHECK(q.distance == 0);
    CHECK(q.normal.isZero(0));
    CHECK(uniform_ball.derivative(q, p, 1).force.isIdentity(0));
    CHECK(uniform_ball.derivative(q, p, 1).size.isZero(0));
  }
}

TEST_CASE("friction ball: at the ends of the range of doubles", "[friction_ball]") {
  for (const double length : {1e-300, 1.0, 1e300, 1.7e308}) {
    for (const double size : {5e-324, 1e-300, 1.0, 1e300}) {
      const FrictionForce p = length * FrictionForce(0.5, -0.25, 0.75);
      const auto q = uniform_ball.project(p, size);
      INFO("length " << length << ", size " << size);
      CHECK(q.inside == (length < size));
      CHECK(q.point.allFinite());
      if (q.inside) continue;
      CHECK(std::abs(q.normal.norm() - 1) <= 4 * eps);
      // From afar the normal is the direction of the force.
      if (length > 1e20 * size) CHECK((q.normal - p / length / std::sqrt(0.875)).norm() <= 8 * eps);
      CHECK(uniform_ball.project(q.point, size).distance <= 4 * std::max(eps * size, 5e-324));
    }
  }
}

TEST_CASE("friction ball: of size zero it is the point zero", "[friction_ball]") {
  const auto q = uniform_ball.project({3, 0, -4}, 0);
  CHECK(q.point == FrictionForce(0, 0, 0));
  CHECK((q.normal - Eigen::Vector3d(0.6, 0, -0.8)).norm() <= 2 * eps);
  CHECK(std::abs(q.distance - 5) <= 5 * eps);
  const auto d = uniform_ball.derivative(q, {3, 0, -4}, 0);
  CHECK(d.force.isZero(0));
  CHECK((d.size - uniform_ball.boundary_point(1, {3, 0, -4})).norm() <= 4 * eps);
  CHECK(uniform_ball.project({0, 0, 0}, 0).inside);
  CHECK(uniform_ball.project({1.7e308, 1.7e308, 1.7e308}, 0).normal.allFinite());
  for (const double component : {5e-324, 1.5e308}) {
    const auto q_end = uniform_ball.project({component, component, 0}, 0);
    CHECK((q_end.normal - Eigen::Vector3d(1, 1, 0) / std::sqrt(2.0)).norm() <= 4 * eps);
  }
}

TEST_CASE("friction ball: derivative against central differences in long steps", "[friction_ball]") {
  // The error of the differences is h²/6 times a third derivative of order 10 ...
  const double h = 1e-4;
  for (const FrictionForce& p :
       {FrictionForce(1, 0.5, 1), FrictionForce(-0.3, 0.2, 0.9), FrictionForce(3, -1, -0.2),
        FrictionForce(0, 0, 1.5), FrictionForce(1e-9, 0, 1.5), FrictionForce(1.2, 0.7, 0)}) {
    check_derivative(hertz_ball, p, 1, h, 1e-6);
    check_derivative(uniform_ball, p, 1, h, 1e-6);
  }
  // ... but at the seam, where f''' is log|1 − u| (uniform), or has a corner (Hertz): of order h log h.
  const Eigen::Vector3d n = unit_normal(1);
  check_derivative(uniform_ball, uniform_ball.boundary_point(1, n) + 0.3 * n, 1, 1e-5, 1e-3);
  check_derivative(hertz_ball, hertz_ball.boundary_point(1, n) + 0.3 * n, 1, 1e-5, 1e-3);
}

TEST_CASE("friction ball: derivative is symmetric, between 0 and 1, homogeneous", "[friction_ball]") {
  for (const double u : speed_ratios) {
    const Eigen::Vector3d n = unit_normal(u);
    const FrictionForce p = uniform_ball.boundary_point(2, n) + 0.7 * n;
    const auto q = uniform_ball.project(p, 2);
    const auto d = uniform_ball.derivative(q, p, 2);
    CHECK(d.force == d.force.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(d.force);
    CHECK(eigen.eigenvalues()[0] >= -8 * eps);
    CHECK(eigen.eigenvalues()[2] <= 1);
    CHECK((d.force * q.normal).norm() <= 8 * eps);
    CHECK((d.force * p + 2 * d.size - q.point).norm() <= 16 * eps * p.norm());
  }
}

TEST_CASE("friction ball: Coulomb's disk in three dimensions is the one in two", "[friction_ball]") {
  const FrictionBall ball{DiskPlate{}};
  const FrictionDisk disk;
  for (const Eigen::Vector2d& p :
       {Eigen::Vector2d(3, -4), Eigen::Vector2d(0.3, 0.1), Eigen::Vector2d(0, 1e200)}) {
    const auto q3 = ball.project({p[0], p[1], 0}, 2);
    const auto q2 = disk.project(p, 2);
    CHECK(q3.inside == q2.inside);
    CHECK((q3.point.head<2>() - q2.point).norm() <= 4 * eps);
    CHECK(q3.point[2] == 0);
    const auto d3 = ball.derivative(q3, {p[0], p[1], 0}, 2);
    const auto d2 = disk.derivative(q2, p, 2);
    CHECK((d3.force.topLeftCorner<2, 2>() - d2.force).norm() <= 8 * eps);
    CHECK((d3.size.head<2>() - d2.size).norm() <= 8 * eps);
  }
}

TEST_CASE("friction ball: what is refused at the door", "[friction_ball]") {
  for (const double size : {-1.0, -5e-324, infinity, no_number}) {
    CHECK_THROWS_AS(uniform_ball.project({1, 0, 0}, size), std::invalid_argument);
    CHECK_THROWS_AS(uniform_ball.support(size, {1, 0, 0}), std::invalid_argument);
    CHECK_THROWS_AS(uniform_ball.contains({1, 0, 0}, size), std::invalid_argument);
    CHECK_THROWS_AS(uniform_ball.boundary_point(size, {1, 0, 0}), std::invalid_argument);
  }
  for (const double bad : {infinity, -infinity, no_number}) {
    for (int i = 0; i < 3; ++i) {
      FrictionForce p(1, 1, 1);
      p[i] = bad;
      CHECK_THROWS_AS(uniform_ball.project(p, 1), std::domain_error);
      CHECK_THROWS_AS(uniform_ball.gauge(p), std::domain_error);
      CHECK_THROWS_AS(uniform_ball.support(1, p), std::domain_error);
    }
  }
  CHECK_THROWS_AS(uniform_ball.normal({0, 0, 0}), std::domain_error);
  CHECK_THROWS_AS(uniform_ball.boundary_point(1, {0, 0, 0}), std::domain_error);
}
