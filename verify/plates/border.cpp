#include "border.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace verify::plates {
namespace {

/// Signed distance from the border point along its normal
/// to the nearest place where the plate begins or ends.
double along_normal(const PlateSeries& plate, const Friction& point, double psi) {
  const auto inside = [&](double t) {
    return contains(plate, std::abs(point.xi + t * std::sin(psi)), point.eta + t * std::cos(psi));
  };
  const double side = inside(0) ? 1 : -1;  // look outwards from inside, inwards from outside
  const auto crossed = [&](double t) { return inside(side * t) != (side > 0); };
  constexpr double finest = 1e-17;
  constexpr double farthest = 1;
  double far = finest;
  while (!crossed(far)) {
    far *= 2;
    if (far > farthest) return side * far;
  }
  double near = far / 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = near + (far - near) / 2;
    (crossed(middle) ? far : near) = middle;
  }
  return side * far;
}

struct Point {
  double xi;
  double eta;
};

/// > 0 if a, b, c turn left.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.xi - a.xi) * (c.eta - a.eta) - (b.eta - a.eta) * (c.xi - a.xi);
}

}  // namespace

Deviation largest_deviation(const PlateSeries& plate, const Border& exact) {
  std::vector<double> angles;
  constexpr int directions = 4000;
  for (int i = 0; i < directions; ++i) angles.push_back(std::numbers::pi / 2 * (i + 0.5) / directions);
  for (int k = 1; k <= 50; ++k) {
    for (const double side : {-1.0, 1.0}) angles.push_back(std::numbers::pi / 4 + side * std::exp2(-k));
  }
  Deviation largest{0, 0, 0};
  for (const double psi : angles) {
    if (!(psi > 0 && psi < std::numbers::pi / 2)) continue;
    const Friction point = exact(psi);
    const double distance = along_normal(plate, point, psi);
    if (std::abs(distance) > std::abs(largest.distance)) largest = {distance, point.xi, std::tan(psi)};
  }
  return largest;
}

double jump(const PlateSeries& plate) {
  return outer_boundary_eta(plate, plate.seam) - inner_boundary_eta(plate, plate.seam);
}

double hull_gap(const PlateSeries& plate) {
  // The upper border from ξ = −1 to 1, dense towards the ends; at the seam both of its values.
  std::vector<Point> border;
  constexpr int points = 2000;
  for (int i = 0; i <= points; ++i) {
    const double xi = std::sin(std::numbers::pi / 2 * i / points);
    border.push_back({xi, boundary_eta(plate, std::min(xi, 1.0))});
  }
  border.push_back({plate.seam, inner_boundary_eta(plate, plate.seam)});
  border.push_back({plate.seam, outer_boundary_eta(plate, plate.seam)});
  const auto half = border;
  for (const Point& p : half) border.push_back({-p.xi, p.eta});
  std::sort(border.begin(), border.end(),
            [](const Point& a, const Point& b) { return a.xi < b.xi || (a.xi == b.xi && a.eta < b.eta); });

  std::vector<Point> hull;
  for (const Point& p : border) {
    while (hull.size() >= 2 && turn(hull[hull.size() - 2], hull.back(), p) >= 0) hull.pop_back();
    hull.push_back(p);
  }
  double gap = 0;
  std::size_t k = 0;
  for (const Point& p : border) {
    while (k + 2 < hull.size() && hull[k + 1].xi < p.xi) ++k;
    const Point& a = hull[k];
    const Point& b = hull[k + 1];
    if (b.xi == a.xi || p.xi == plate.seam || p.xi == -plate.seam)
      continue;  // the step itself is judged by its neighbours
    gap = std::max(gap, a.eta + (b.eta - a.eta) * (p.xi - a.xi) / (b.xi - a.xi) - p.eta);
  }
  return gap;
}

}  // namespace verify::plates
