#include "order.hpp"

#include <cmath>

namespace verify::siconos {

double order(const std::vector<double>& points, const std::vector<double>& errors) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double a = std::log(points[i]);
    const double b = std::log(errors[i]);
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const auto n = static_cast<double>(points.size());
  return (x * y - n * xy) / (n * xx - x * x);
}

}  // namespace verify::siconos
