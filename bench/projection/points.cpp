#include "points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "contensou/output/table.hpp"

namespace bench {
namespace {

/// A border point of the plate and the angle ψ of its normal, u = tan ψ.
struct Border {
  long double angle, xi, eta;
};

void append(std::vector<Border>& border, const std::filesystem::path& path) {
  const contensou::Table table = contensou::read_table(path);
  const auto u = table.texts("u");
  const auto xi = table.texts("xi");
  const auto eta = table.texts("eta");
  const auto number = [](const std::string& text) { return std::strtold(text.c_str(), nullptr); };
  for (std::size_t i = 0; i < u.size(); ++i) {
    border.push_back({std::atan(number(u[i])), number(xi[i]), number(eta[i])});
  }
}

std::vector<Border> read_border(const std::filesystem::path& reference, const std::string& pressure) {
  std::string name = pressure;
  std::replace(name.begin(), name.end(), ':', '_');
  std::vector<Border> border;
  append(border, reference / "laws" / (name + ".tsv"));
  const std::filesystem::path more = reference / "accuracy" / (name + ".tsv");
  if (std::filesystem::exists(more)) append(border, more);
  std::sort(border.begin(), border.end(), [](const Border& a, const Border& b) { return a.angle < b.angle; });
  return border;
}

const Border& nearest(const std::vector<Border>& border, double angle) {
  auto above = std::lower_bound(border.begin(), border.end(), angle,
                                [](const Border& b, double x) { return b.angle < x; });
  if (above == border.end()) return border.back();
  if (above == border.begin()) return border.front();
  return above->angle - angle < angle - std::prev(above)->angle ? *above : *std::prev(above);
}

}  // namespace

std::vector<Point> points(const std::filesystem::path& reference, const std::string& pressure,
                          std::size_t count) {
  const std::vector<Border> border = read_border(reference, pressure);
  std::mt19937_64 generator(4);
  const auto random = [&generator] { return static_cast<double>(generator() >> 11U) * 0x1p-53; };
  const auto log_uniform = [&random](double low, double high) {
    return low * std::pow(high / low, random());
  };
  std::vector<Point> found;
  found.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Border& x = nearest(border, std::numbers::pi / 2 * random());
    const long double around = 2 * std::numbers::pi_v<long double> * random();
    const long double side = random() < 0.5 ? -1 : 1;
    const auto vector = [&](long double t, long double tau) {
      return std::array{t * std::cos(around), t * std::sin(around), side * tau};
    };
    const double kind = random();
    const Place place = kind < 0.25 ? Place::inside : kind < 0.75 ? Place::near : Place::far;
    const auto exact_force = [&] {
      if (place == Place::inside) {
        const double part = random();
        return vector(part * x.xi, part * x.eta);
      }
      const double distance = place == Place::near ? log_uniform(1e-3, 0.1) : log_uniform(0.1, 1000);
      return vector(x.xi + distance * std::sin(x.angle), x.eta + distance * std::cos(x.angle));
    }();
    Point point{place, {}, vector(x.xi, x.eta)};
    for (std::size_t k = 0; k < 3; ++k) {
      point.force[static_cast<Eigen::Index>(k)] = static_cast<double>(exact_force[k]);
      if (place == Place::inside) point.nearest[k] = point.force[static_cast<Eigen::Index>(k)];
    }
    found.push_back(point);
  }
  return found;
}

}  // namespace bench
