#include "points.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace verify::siconos {
namespace {

constexpr double pi = std::numbers::pi;

struct Node {
  double t, weight;
};

/// Gauss–Legendre on [0, 1] by Newton's method on the Legendre polynomial.
std::vector<Node> gauss_legendre(int n) {
  std::vector<Node> nodes;
  for (int i = 0; i < n; ++i) {
    double x = std::cos(pi * (i + 0.75) / (n + 0.5));
    double slope = 0;
    for (int step = 0; step < 8; ++step) {
      double before = 1;
      double p = x;
      for (int k = 2; k <= n; ++k) before = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * before) / k);
      slope = n * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    nodes.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

}  // namespace

std::vector<PatchPoint> rings(Pressure pressure, int n) {
  const int angles = 4 * n;
  std::vector<PatchPoint> points;
  for (const auto& [t, weight] : gauss_legendre(n)) {
    const bool uniform = pressure == Pressure::uniform;
    const double rho = uniform ? std::sqrt(t) : std::sqrt(1 - t * t);
    const double share = (uniform ? 1 : 3 * t * t) * weight / angles;
    for (int j = 0; j < angles; ++j) {
      const double phi = 2 * pi * j / angles;
      points.push_back({rho * std::cos(phi), rho * std::sin(phi), share});
    }
  }
  return points;
}

std::vector<PatchPoint> sunflower(Pressure pressure, int count) {
  const double turn = 2 * pi * (1 - 1 / std::numbers::phi);
  std::vector<PatchPoint> points;
  for (int i = 0; i < count; ++i) {
    const double enclosed = (i + 0.5) / count;
    const double square = pressure == Pressure::uniform ? enclosed : 1 - std::pow(1 - enclosed, 2.0 / 3);
    const double rho = std::sqrt(square);
    points.push_back({rho * std::cos(turn * i), rho * std::sin(turn * i), 1.0 / count});
  }
  return points;
}

}  // namespace verify::siconos
