#include "contensou/system/free_body.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "differences.hpp"

using namespace contensou;
using namespace system_test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

State tumbling() {
  State s{0, Eigen::VectorXd(4), Eigen::VectorXd(3)};
  s.q << 0.5, -0.3, 0.7, 0.4;
  s.q.normalize();
  s.u << 0.9, -1.3, 0.6;
  return s;
}

}  // namespace

TEST_CASE("Free body: its terms by differences", "[system]") {
  for (const FreeBodyData& data :
       {FreeBodyData{.i1 = 0.7, .i2 = 1.1, .i3 = 1.5}, FreeBodyData{.i1 = 1.2, .i2 = 1.2, .i3 = 0.5}}) {
    check_terms(FreeBody(data), tumbling());
  }
}

TEST_CASE("Free body: turns as its spin says, and keeps its angular momentum", "[system]") {
  const FreeBody body({.i1 = 0.7, .i2 = 1.1, .i3 = 1.5});
  const State s = tumbling();
  // the attitude from the columns' own definition: a vector v goes to q v q*
  const Eigen::Quaterniond q(s.q[0], s.q[1], s.q[2], s.q[3]);
  const Matrix3d attitude = body.attitude(s.q);
  CHECK((attitude * Vector3d(1, 2, 3) - q._transformVector(Vector3d(1, 2, 3))).norm() <= 1e-15 * 4);
  const Matrix3d turning = rate(
      [&](double t) -> Matrix3d { return body.attitude(moved(body, s, Eigen::VectorXd::Zero(3), t).q); });
  for (int k = 0; k < 3; ++k) {
    const Vector3d expected = attitude * Vector3d(s.u).cross(Vector3d::Unit(k));
    CHECK((turning.col(k) - expected).norm() <= difference_bound);
  }
  Eigen::VectorXd acceleration(3);
  body.free_acceleration(0, s.q, s.u, acceleration);
  const Vector3d change = rate([&](double t) -> Vector3d {
    const State later = moved(body, s, acceleration, t);
    return body.angular_momentum(later.q, later.u);
  });
  CHECK(change.norm() <= difference_bound);
  CHECK(body.potential_energy(s.q) == 0);
}

TEST_CASE("Free body: restored to unit length, once", "[system]") {
  const FreeBody body({});
  Eigen::VectorXd q = 1.001 * tumbling().q;
  body.restore(q);
  CHECK((q - tumbling().q).norm() <= 3e-16);
  const Eigen::VectorXd once = q;
  body.restore(q);
  CHECK((q - once).norm() == 0);
}

TEST_CASE("Free body: bad data give one clear line", "[system]") {
  CHECK_THROWS_WITH(FreeBody({.i1 = 0}), "free body: i1 0, expected a number > 0");
  CHECK_THROWS_WITH(FreeBody({.i2 = NAN}), "free body: i2 nan, expected a number > 0");
  CHECK_THROWS_WITH(FreeBody({.i3 = 3.5}), "free body: i3 3.5, expected at most i1 + i2");
  CHECK_THROWS_WITH(FreeBody({.i1 = 7}), "free body: i1 7, expected at most i2 + i3");
  CHECK_THROWS_WITH(FreeBody({.i2 = 5}), "free body: i2 5, expected at most i3 + i1");
  CHECK_NOTHROW(FreeBody({.i1 = 0.1, .i2 = 0.2, .i3 = 0.1 + 0.2}));  // flat
  CHECK_THROWS_AS(FreeBody({}).gap(0, 0, tumbling().q), std::out_of_range);
}
