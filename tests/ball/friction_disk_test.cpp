#include "contensou/ball/friction_disk.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace contensou;
using Eigen::Vector2d;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();
const FrictionDisk disk;
const Vector2d diagonal = Vector2d(1, 1) / std::sqrt(2.0);

}  // namespace

TEST_CASE("friction disk: a force longer than the largest double", "[friction_disk]") {
  const Vector2d force(1.5e308, 1.5e308);  // length 2.12e308
  for (const double size : {0.0, 1.0, 1e308, largest}) {
    const auto q = disk.project(force, size);
    CAPTURE(size);
    CHECK_FALSE(q.inside);
    CHECK_FALSE(disk.contains(force, size));
    CHECK((q.normal - diagonal).norm() <= 2 * eps);
    CHECK((q.point / std::max(size, 1.0) - size / std::max(size, 1.0) * diagonal).norm() <= 4 * eps);
    CHECK(std::isfinite(q.distance));
    CHECK(q.distance > 0.3e308);
    const auto d = disk.derivative(q, force, size);
    // The share size/length, across the force: (1, -1) (1, -1)ᵀ/2.
    const double share = size / 1.5e308 / std::sqrt(2.0);
    CHECK((d.force - share * (Eigen::Matrix2d() << 0.5, -0.5, -0.5, 0.5).finished()).norm() <= 4 * eps);
  }
  CHECK(disk.contains({1e308, 1e308}, 1.5e308));
  CHECK(disk.gauge({1e308, 1e308}) == Approx(std::sqrt(2.0) * 1e308));
}

TEST_CASE("friction disk: the smallest forces", "[friction_disk]") {
  const Vector2d force(smallest, smallest);
  const auto q = disk.project(force, 0);
  CHECK_FALSE(q.inside);
  CHECK((q.normal - diagonal).norm() <= 2 * eps);
  CHECK(q.point.isZero(0));
  CHECK(q.distance == smallest);  // √2 of it, rounded
  CHECK_FALSE(disk.contains(force, smallest));
  CHECK(disk.contains(force, 2 * smallest));
  CHECK(disk.contains({0, 0}, 0));
  CHECK(disk.contains({smallest, 0}, smallest));
}
