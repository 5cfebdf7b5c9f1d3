#include "contensou/ball/series_plate.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

using namespace contensou;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// The border as (2.18), (3.19) have it, by `count` points on either piece, with the two ends of the step.
std::vector<Meridian> border(const PlateSeries& series, int count) {
  std::vector<Meridian> points;
  for (int i = 0; i <= count; ++i) {
    const double xi = series.seam * i / count;
    points.push_back({xi, inner_boundary_eta(series, xi)});
  }
  const double top = outer_boundary_eta(series, series.seam);
  for (int i = 0; i <= count; ++i) {
    // outer_boundary_eta is steep at ξ = 1: equal steps of an angle instead
    const double xi = series.seam + (1 - series.seam) * std::sin(std::acos(-1.0) / 2 * i / count);
    points.push_back({xi, outer_boundary_eta(series, xi)});
    points.push_back({series.seam, top + (points[static_cast<std::size_t>(count)].tau - top) * i / count});
  }
  return points;
}

}  // namespace

TEST_CASE("series plate: the projection is the nearest point of the border, wherever that is",
          "[series_plate]") {
  for (const PlateSeries& series : {printed_uniform_plate(), printed_hertz_plate(), plate_series(0, 3),
                                    plate_series(0.5, 3), plate_series(0.5, 20)}) {
    const SeriesPlate plate(series);
    const std::vector<Meridian> points = border(series, 2000);
    const double top = outer_boundary_eta(series, series.seam);
    int outside = 0;
    for (double t = 0; t <= 1.6; t += 0.0731) {
      for (double tau = 0; tau <= 1.2; tau += 0.0517) {
        const PlateProjection q = plate.project({t, tau}, 1);
        // Beyond its border the outer polynomial may turn and fall below 1 again: that is not the plate.
        CHECK(q.inside == (contains(series, t, tau) && (t <= series.seam || tau <= top)));
        if (q.inside) continue;
        ++outside;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Meridian& b : points) nearest = std::min(nearest, std::hypot(t - b.t, tau - b.tau));
        INFO("point " << t << ", " << tau << ", seam " << series.seam);
        CHECK(std::abs(std::hypot(t - q.point.t, tau - q.point.tau) - q.distance) <= 4 * eps * 2);
        CHECK(q.distance <= nearest + 4 * eps);
        // Points 1e-3 apart at most: nearer by no more than the half square of that over the distance.
        CHECK(q.distance >= nearest - std::min(1e-3, 1e-6 / q.distance));
        CHECK(q.residual <= 8 * eps);
      }
    }
    CHECK(outside > 200);
  }
}

TEST_CASE("series plate: support is that of the convex hull", "[series_plate]") {
  const PlateSeries series = printed_hertz_plate();
  const SeriesPlate plate(series);
  const std::vector<Meridian> points = border(series, 4000);
  for (double angle = 0; angle <= 1.58; angle += 0.05) {
    const double v = std::sin(angle);
    const double s = std::max(0.0, std::cos(angle));
    double farthest = 0;
    for (const Meridian& b : points) farthest = std::max(farthest, v * b.t + s * b.tau);
    CHECK(plate.support(v, s) >= farthest - 4 * eps);
    CHECK(plate.support(v, s) <= farthest + 1e-6);
  }
  CHECK(plate.support(0, 0) == 0);
}

TEST_CASE("series plate: rays leave where the left side is 1", "[series_plate]") {
  for (const PlateSeries& series : {printed_uniform_plate(), plate_series(0.5, 3)}) {
    const SeriesPlate plate(series);
    for (double angle = 0.02; angle < 1.57; angle += 0.04) {
      const double t = std::cos(angle);
      const double tau = std::sin(angle);
      const double gauge = plate.ray(t, tau).gauge;
      const double xi = t / gauge;
      const double eta = tau / gauge;
      if (std::abs(xi - series.seam) < 1e-9) continue;  // through the step
      CHECK(std::abs(left_side(series, xi, eta) - 1) <= 32 * eps);
    }
    CHECK(std::abs(plate.ray(0, 2).gauge - 2 / series.extent.eta) <= 4 * eps * 3);
    CHECK(plate.ray(2, 0).gauge == 2);
  }
}

TEST_CASE("series plate: curvature of the border", "[series_plate]") {
  const PlateSeries series = plate_series(0.5, 3);
  const SeriesPlate plate(series);
  // Hertz, u = 0: radius f''(0) = 3π/8; u = ∞: u³f'' = 1/5.
  CHECK(std::abs(plate.curvature_radius(plate.project({0, 1}, 1)) - 3 * std::acos(-1.0) / 8) <= 1e-14);
  CHECK(std::abs(plate.curvature_radius(plate.project({2, 0}, 1)) - 0.2) <= 1e-15);
}
