#include "contensou/system/contact_geometry.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "differences.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("Contact axes: right-handed, orthonormal, the floor's are the axes", "[system][bodies]") {
  CHECK((contact_axes(Vector3d::UnitZ()).col(1) - Vector3d::UnitX()).norm() == 0);
  CHECK((contact_axes(Vector3d::UnitZ()).col(2) - Vector3d::UnitY()).norm() == 0);
  for (double height = -1; height <= 1; height += 0.05) {
    for (double angle = 0; angle < 6; angle += 0.7) {
      const double across = std::sqrt(std::max(1 - height * height, 0.0));
      const Vector3d n(across * std::cos(angle), across * std::sin(angle), height);
      const Matrix3d axes = contact_axes(n);
      // 1 + |n_z| >= 0.1 divides: ten roundings.
      CHECK((axes.transpose() * axes - Matrix3d::Identity()).norm() <= 1e-14);
      CHECK(std::abs(axes.determinant() - 1) <= 1e-14);
      CHECK((axes.col(0) - n).norm() == 0);
    }
  }
}

TEST_CASE("Contact axes: their rate by differences, on both sides of the seam", "[system][bodies]") {
  for (const Vector3d& direction : {Vector3d(0.3, -0.5, 0.7), Vector3d(1, 0, 0), Vector3d(0.5, 0.2, -0.6),
                                    Vector3d(0.1, -0.2, -0.9), Vector3d(0, 0, -1), Vector3d(0, 0, 1)}) {
    const Vector3d n = direction.normalized();
    const Vector3d omega(0.4, -0.3, 0.8);
    const auto at = [&](double t) -> Matrix3d {
      return contact_axes(Eigen::AngleAxisd(t * omega.norm(), omega.normalized()) * n);
    };
    CHECK((rate(at) - contact_axes_rate(n, omega.cross(n))).norm() <= difference_bound);
  }
}

TEST_CASE("Spheres: gap, and points that touch", "[system][bodies]") {
  CHECK(sphere_gap({1, 2, 2}, 0.5, {0, 0, 0}, 1.5) == 1);
  const MovingSphere one{{1, 2, 2}, {0.1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0.5};
  const MovingSphere other{{0, 0, 0}, {0, -0.2, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1.5};
  const SphereContact contact = sphere_contact(one, other, true);
  const Vector3d n = Vector3d(1, 2, 2) / 3;
  CHECK((contact.axes.col(0) - n).norm() <= 1e-16);
  CHECK((contact.lever - (Vector3d(0.1, 0, 0) - 0.5 * n)).norm() <= 1e-15);
  CHECK((contact.other - (Vector3d(0, -0.2, 0) + 1.5 * n)).norm() <= 1e-15);
  CHECK(contact.drift.norm() == 0);
  CHECK(contact.spin_drift == 0);
  const SphereContact smooth = sphere_contact(one, other, false);
  CHECK((smooth.axes.col(0) - contact.axes.col(0)).norm() == 0);
  CHECK((smooth.lever - contact.lever).norm() == 0);
  CHECK(smooth.axes.rightCols<2>().isZero(0));
}
