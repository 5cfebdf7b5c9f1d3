#include "contensou/ball/series_arc.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "contensou/ball/bracketed_newton.hpp"

namespace contensou {
namespace {

/// A value is zero where it is below the rounding of its largest term.
NewtonStep step(double value, double fall, double largest_term) {
  constexpr double rounding = 0x1p-51;
  return {value, fall, std::abs(value) <= rounding * largest_term};
}

}  // namespace

SeriesArc::SeriesArc(double height, std::vector<double> coefficients, double end)
    : height_(height), coefficients_(std::move(coefficients)) {
  end_ = at(end);
  if (!(end_.y > 0)) throw std::invalid_argument("friction plate: its series have no border up to the seam");
}

SeriesArc::Point SeriesArc::at(double x) const {
  const double q = x * x;
  double p = 0;  // c_1 + c_2 q + ..., and its first two derivatives
  double p1 = 0;
  double p2 = 0;
  for (auto c = coefficients_.rbegin(); c != coefficients_.rend(); ++c) {
    p2 = p2 * q + 2 * p1;
    p1 = p1 * q + p;
    p = p * q + *c;
  }
  const double fall = p + q * p1;  // −d/dq of the radicand
  const double fall_rate = 2 * p1 + q * p2;
  const double root = std::sqrt(1 - q * p);
  const double slope = -fall * x / root;
  return {x, height_ * root, height_ * slope,
          -height_ * (fall + 2 * q * fall_rate) / root - height_ * slope * slope / root};
}

template <class Function>
SeriesArc::Found SeriesArc::solve(const Function& function) const {
  const Point start = at(0);
  const NewtonStep first = function(start);
  const NewtonStep last = function(end_);
  if (last.value > 0) return {end_, true, 2};
  if (!(first.value > 0)) return {start, false, 2};
  const double guess =
      end_.x * inverse_cubic(first.value, first.fall * end_.x, last.value, last.fall * end_.x);
  Point point = start;
  const NewtonEnd end = bracketed_newton({0, end_.x}, guess, [&](double x) {
    point = at(x);
    return function(point);
  });
  return {point, false, end.iterations + 2};
}

SeriesArc::Found SeriesArc::nearest(double a, double b, double size) const {
  return solve([=](const Point& p) {
    const double above = b - size * p.y;
    return step(a - size * p.x + above * p.slope, size * (1 + p.slope * p.slope) - above * p.second,
                std::max(a, std::max(b, size) * -p.slope));
  });
}

SeriesArc::Found SeriesArc::crossing(double a, double b) const {
  return solve([=](const Point& p) { return step(a * p.y - b * p.x, b - a * p.slope, a * p.y); });
}

SeriesArc::Found SeriesArc::touching(double v, double s) const {
  return solve([=](const Point& p) { return step(v + s * p.slope, -s * p.second, v); });
}

}  // namespace contensou
