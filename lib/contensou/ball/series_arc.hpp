#pragma once

#include <vector>

namespace contensou {

/// The border of one piece of a PlateSeries: y(x) = height √(1 − c_1 x² − c_2 x⁴ − ...) for 0 <= x <= end,
/// falling from y(0) = height, concave where it is a good plate (see SeriesPlate).
class SeriesArc {
 public:
  /// Throws std::invalid_argument if the arc ends before `end`.
  SeriesArc(double height, std::vector<double> coefficients, double end);

  struct Point {
    double x, y;
    double slope;   ///< y'(x)
    double second;  ///< y''(x)
  };
  /// Where on the arc; `corner` if it is its end because what is sought lies beyond.
  struct Found {
    Point at;
    bool corner;
    int iterations;
  };

  Point at(double x) const;
  const Point& end() const { return end_; }
  /// The point of the arc, scaled by `size`, nearest to (a, b), which lies above its end, b >= size y(end).
  Found nearest(double a, double b, double size) const;
  /// The point on the ray from the origin through (a, b), a > 0; the corner where the ray passes beyond it.
  Found crossing(double a, double b) const;
  /// The point with outward normal (v, s), s > 0.
  Found touching(double v, double s) const;

 private:
  template <class Function>
  Found solve(const Function& function) const;

  double height_;
  std::vector<double> coefficients_;
  Point end_;
};

}  // namespace contensou
