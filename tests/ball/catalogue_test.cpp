#include "contensou/ball/catalogue.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

using namespace contensou;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <class Plate>
bool is(const AnyBall& ball) {
  return std::holds_alternative<FrictionBall<Plate>>(ball);
}

double distance(const AnyBall& any, const FrictionForce& p) {
  return std::visit([&](const auto& ball) { return ball.project(p, 1).distance; }, any);
}

}  // namespace

TEST_CASE("balls by name", "[ball_catalogue]") {
  CHECK(is<SmoothPlate<UniformLaw>>(make_ball("uniform")));
  CHECK(is<SmoothPlate<HertzLaw>>(make_ball("hertz")));
  CHECK(is<SmoothPlate<CompiledLaw>>(make_ball("power:2")));
  CHECK(is<SmoothPlate<EllipsoidLaw>>(make_ball("hertz", "ellipsoid")));
  CHECK(is<RectanglePlate>(make_ball("hertz", "decoupled")));
  CHECK(is<DiskPlate>(make_ball("power:3", "disk")));
  CHECK(is<TabulatedPlate>(make_ball("uniform", "table:8")));
  for (const char* model : {"printed", "series", "corrected", "series:12"}) {
    CHECK(is<SeriesPlate>(make_ball("uniform", model)));
    CHECK(is<SeriesPlate>(make_ball("hertz", model)));
  }
  CHECK(is<SeriesPlate>(make_ball("power:2", "series")));
}

TEST_CASE("balls by name are near to one another, and the better the nearer", "[ball_catalogue]") {
  const FrictionForce p(0.7, 0.5, -0.6);
  for (const std::string pressure : {"uniform", "hertz"}) {
    const double exact = distance(make_ball(pressure), p);
    const auto error = [&](const char* model) {
      return std::abs(distance(make_ball(pressure, model), p) - exact);
    };
    CHECK(error("table:64") <= 1e-8);
    CHECK(error("table:8") <= 1e-4);
    CHECK(error("series:40") <= 1e-3);
    CHECK(error("corrected") <= 2e-2);
    CHECK(error("printed") <= 2e-2);
    CHECK(error("ellipsoid") <= 0.1);
    CHECK(error("decoupled") > 0.1);
    CHECK(error("disk") > 0.1);
  }
}

TEST_CASE("balls by name: what there is not", "[ball_catalogue]") {
  using Catch::Matchers::Contains;
  const auto refuse = [](const char* pressure, const char* model, const std::string& text) {
    INFO(pressure << " " << model);
    CHECK_THROWS_WITH(make_ball(pressure, model), Contains(text) && !Contains("\n"));
    CHECK_THROWS_AS(make_ball(pressure, model), std::invalid_argument);
  };
  refuse("uniform", "pade", "pade: has no friction ball");
  refuse("uniform", "pade2", "not the gradient of a potential");
  refuse("hertz", "tanh:1e-3", "nothing sticks");
  refuse("hertz", "table:3", "expected table:N");
  refuse("hertz", "table:257", "expected table:N");
  refuse("hertz", "table:8.5", "expected table:N");
  refuse("hertz", "series:0", "expected series:K");
  refuse("hertz", "series:41", "expected series:K");
  refuse("power:2", "printed", "for which the paper prints");
  refuse("hertz", "sphere", "sphere: expected exact");
  refuse("parabolic", "exact", "parabolic: expected uniform");
  refuse("power:-2", "disk", "expected power:N with N > -1");
}

TEST_CASE("balls by name: rectangle and disk in closed form", "[ball_catalogue]") {
  const FrictionBall ball{RectanglePlate({1, 0.5})};
  const auto corner = ball.project({0, 4, 2.5}, 1);
  CHECK(corner.point == FrictionForce(0, 1, 0.5));
  CHECK(std::abs(corner.distance - std::sqrt(13.0)) <= 4 * eps);
  CHECK(ball.project({0.3, 0, -2}, 1).point == FrictionForce(0.3, 0, -0.5));
  CHECK(ball.project({0.3, 0.4, 0.5}, 1).inside);
  CHECK(ball.gauge({0.2, 0, 1}) == 2);
  CHECK(ball.normal({0.2, 0, 1}) == Eigen::Vector3d(0, 0, 1));
  // Along the top the projection slides, in the corner it turns about the axis only.
  const FrictionForce top(0.3, 0, 2);
  CHECK(ball.derivative(ball.project(top, 1), top, 1)
            .force.isApprox(Eigen::Vector3d(1, 1, 0).asDiagonal().toDenseMatrix(), 4 * eps));
  const FrictionForce beyond(2, 0, 2);
  CHECK(ball.derivative(ball.project(beyond, 1), beyond, 1)
            .force.isApprox(Eigen::Vector3d(0, 0.5, 0).asDiagonal().toDenseMatrix(), 4 * eps));
  const FrictionBall disk{DiskPlate{}};
  CHECK(std::isinf(disk.gauge({0.1, 0, 1e-300})));
  CHECK_FALSE(disk.contains({0.1, 0, 1e-300}, 1));
  CHECK(disk.contains({0.6, 0.8, 0}, 1));
}
