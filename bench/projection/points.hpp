#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// Where a force to be projected lies: inside the friction ball, 1e-3 to 0.1 μλ_N outside, 0.1 to 1000.
enum class Place { inside, near, far };

/// A force and the nearest point of the friction ball, in units of μλ_N.
struct Point {
  Place place;
  Eigen::Vector3d force;
  std::array<long double, 3> nearest;  ///< to 2e-16, what the rounding of `force` makes of it
};

/// `count` forces in random order: a quarter inside, half near, a quarter far. No projection is behind them:
/// a force outside is a border point x(u) of the tables in `reference` (34 digits) plus a distance,
/// log-uniform within its range, along the normal there, so that x(u) is its projection; a force inside is a
/// part, uniform in [0, 1), of a border point. The normals are even in angle, 0 to 90°, each the nearest in
/// the tables; the directions around the axis and the signs are random.
std::vector<Point> points(const std::filesystem::path& reference, const std::string& pressure,
                          std::size_t count);

}  // namespace bench
