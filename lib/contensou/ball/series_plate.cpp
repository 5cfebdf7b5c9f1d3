#include "contensou/ball/series_plate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace contensou {
namespace {

/// The direction of a vector, its larger component of size 1.
Meridian direction_of(Meridian n) {
  const double largest = std::max(std::abs(n.t), std::abs(n.tau));
  return {n.t / largest, n.tau / largest};
}

/// The projection of p on a point of the border with a normal of any length there.
PlateProjection projection(Meridian p, Meridian point, Meridian normal, int iterations) {
  const Meridian n = direction_of(normal);
  const double length = std::sqrt(n.t * n.t + n.tau * n.tau);
  const double t = p.t - point.t;
  const double tau = p.tau - point.tau;
  const double distance = (t * n.t + tau * n.tau) / length;
  if (!(distance > 0)) return {p, {0, 0}, 0, 0, iterations, true};
  return {point, n, distance, std::abs(t * n.tau - tau * n.t) / length, iterations, false};
}

}  // namespace

SeriesPlate::SeriesPlate(const PlateSeries& series)
    : series_(series),
      inner_(series.extent.eta, series.inner, series.seam),
      outer_(series.extent.xi, series.outer, outer_boundary_eta(series, series.seam)) {}

double SeriesPlate::support(double v, double s) const {
  if (v == 0 && s == 0) return 0;
  const Friction x = border(v, s);
  return v * x.xi + s * x.eta;
}

Friction SeriesPlate::border(double v, double s) const {
  if (v == 0) return {0, series_.extent.eta};
  if (s == 0) return {series_.extent.xi, 0};
  const SeriesArc::Point a = inner_.touching(v, s).at;
  const SeriesArc::Point b = outer_.touching(s, v).at;
  if (v * a.x + s * a.y >= v * b.y + s * b.x) return {a.x, a.y};
  return {b.y, b.x};
}

PlateRay SeriesPlate::ray(double t, double tau) const {
  if (t == 0) return {tau / series_.extent.eta, {0, 1}, 0};
  if (tau == 0) return {t / series_.extent.xi, {1, 0}, 0};
  const SeriesArc::Found a = inner_.crossing(t, tau);
  const SeriesArc::Found b = outer_.crossing(tau, t);
  PlateRay ray{std::numeric_limits<double>::infinity(), {}, a.iterations + b.iterations};
  if (!a.corner) {
    ray.gauge = tau / a.at.y;
    ray.direction = direction_of({-a.at.slope, 1});
  }
  if (!b.corner && t / b.at.y < ray.gauge) {
    ray.gauge = t / b.at.y;
    ray.direction = direction_of({1, -b.at.slope});
  }
  // Below the end of the inner piece and above the beginning of the outer one: through the step between them.
  if (a.corner && b.corner) return {t / series_.seam, {1, 0}, ray.iterations};
  return ray;
}

bool SeriesPlate::contains(Meridian p, double size) const {
  const double xi = p.t / size;
  const double eta = p.tau / size;
  return contensou::contains(series_, xi, eta) && (xi <= series_.seam || eta <= outer_.end().x);
}

PlateProjection SeriesPlate::onto_inner(Meridian p, double size) const {
  const double end = size * inner_.end().x;
  if (p.tau <= size * inner_.end().y) return projection(p, {end, p.tau}, {1, 0}, 0);
  const SeriesArc::Found found = inner_.nearest(p.t, p.tau, size);
  const Meridian point{size * found.at.x, size * found.at.y};
  if (found.corner) return projection(p, point, {p.t - point.t, p.tau - point.tau}, found.iterations);
  return projection(p, point, {-found.at.slope, 1}, found.iterations);
}

PlateProjection SeriesPlate::onto_outer(Meridian p, double size) const {
  const double beginning = size * series_.seam;
  const double top = size * outer_.end().x;
  if (p.t <= beginning) {
    const Meridian point{beginning, std::min(p.tau, top)};
    return projection(p, point, {p.t - point.t, p.tau - point.tau}, 0);
  }
  const SeriesArc::Found found = outer_.nearest(p.tau, p.t, size);
  const Meridian point{size * found.at.y, size * found.at.x};
  if (found.corner) return projection(p, point, {p.t - point.t, p.tau - point.tau}, found.iterations);
  return projection(p, point, {1, -found.at.slope}, found.iterations);
}

PlateProjection SeriesPlate::project(Meridian p, double size) const {
  if (contains(p, size)) return {p, {0, 0}, 0, 0, 0, true};
  const PlateProjection a = onto_inner(p, size);
  const PlateProjection b = onto_outer(p, size);
  PlateProjection nearer = a.inside || (!b.inside && a.distance <= b.distance) ? a : b;
  nearer.iterations = a.iterations + b.iterations;
  return nearer;
}

double SeriesPlate::curvature_radius(const PlateProjection& q) const {
  const auto radius = [](const SeriesArc::Point& p) {
    const double square = 1 + p.slope * p.slope;
    return square * std::sqrt(square) / std::abs(p.second);
  };
  const auto [t, tau] = q.point;
  const SeriesArc::Point& a = inner_.end();
  const SeriesArc::Point& b = outer_.end();
  if (tau * a.x > t * a.y) return radius(inner_.crossing(t, tau).at);
  if (t * b.x > tau * b.y) return radius(outer_.crossing(tau, t).at);
  return q.direction.tau == 0 ? std::numeric_limits<double>::infinity() : 0;
}

}  // namespace contensou
