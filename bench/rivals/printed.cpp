#include "rivals/printed.hpp"

#include <cmath>
#include <numbers>

namespace rivals {
namespace {

using std::numbers::pi;

contensou::Reduced hertz(double u) {
  const double u2 = u * u;
  const double u4 = u2 * u2;
  const double length = std::hypot(u, 1.0);
  if (u <= 1) {
    return {3 * pi / 128 * (-u4 + 8 * u2 + 8) / length,  // (3.14)
            3 * pi / 32 * u * (-u2 + 4),                 // (3.17)
            3 * pi / 128 * (3 * u4 - 8 * u2 + 8)};       // (3.18)
  }
  const double arc = std::asin(1 / u);
  const double root = std::sqrt(u2 - 1);
  return {3.0 / 64 * ((-u4 + 8 * u2 + 8) * arc + (u2 + 14) * root) / length,
          3.0 / 16 * (1 / u) * (u2 * (4 - u2) * arc + (u2 + 2) * root),
          3.0 / 64 * ((3 * u4 - 8 * u2 + 8) * arc + (-3 * u2 + 6) * root)};
}

double hertz_second(double u) {
  const double u2 = u * u;
  if (u <= 1) return 3 * pi / 32 * (4 - 3 * u2);
  return 3.0 / 16 * ((4 - 3 * u2) * std::asin(1 / u) + (3 - 2 / u2) * std::sqrt(u2 - 1));
}

contensou::Reduced uniform(double u) {
  const double u2 = u * u;
  const double length = std::hypot(u, 1.0);
  if (u <= 1) {
    const double u4 = u2 * u2;
    const double u6 = u4 * u2;
    return {(2.0 / 3 + u2 / 2 - u4 / 32 - u6 / 384) / length,  // (2.8)
            u - u2 * u / 8 - u4 * u / 64,                      // (2.13)
            2.0 / 3 - u2 / 2 + 3 * u4 / 32 + 5 * u6 / 384};    // (2.14)
  }
  const double w = 1 / u;
  const double w2 = w * w;
  const double w4 = w2 * w2;
  return {(u + w / 8 + w2 * w / 192 + w4 * w / 1024) / length, 1 - w2 / 8 - w4 / 64 - 5 * w4 * w2 / 1024,
          w / 4 + w2 * w / 48 + 3 * w4 * w / 512};
}

double uniform_second(double u) {
  const double u2 = u * u;
  if (u <= 1) return 1 - 3 * u2 / 8 - 5 * u2 * u2 / 64;
  const double w = 1 / u;
  const double w3 = w * w * w;
  return w3 / 4 + w3 * w * w / 16 + 15 * w3 * w3 * w / 512;
}

}  // namespace

const ClosedForm printed_hertz{hertz, hertz_second};
const ClosedForm printed_uniform{uniform, uniform_second};

}  // namespace rivals
