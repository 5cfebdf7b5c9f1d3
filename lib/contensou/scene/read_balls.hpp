#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "contensou/scene/reader.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// The most balls a scene may have: beyond them a misplaced exponent is likelier than a wish.
inline constexpr int most_balls = 1'000'000;

/// [balls.NAME]: homogeneous balls on a lattice.
struct BallsScene {
  BodyData ball;  ///< what all have in common; its one sphere
  int count = 0;
  Eigen::Vector3d lower;  ///< lowest corner of the lattice: centre of the first ball [m]
  double spacing = 0;     ///< [m]
  int across[2] = {1, 1};
  double jitter = 0;  ///< [m]
  int seed = 0;
};

BallsScene read_balls(SceneReader& read, const std::string& name);

/// The balls NAME.1, NAME.2, ...: each at its point of the lattice, points counted along x, then y, then z,
/// moved by jitter·(a, b, c) with a, b, c from −1 to 1 made of three numbers of std::mt19937_64(seed): their
/// upper 53 bits k as 2k/2^53 − 1, the same on every platform.
void append_balls(const BallsScene& balls, std::vector<BodyData>& bodies);

}  // namespace contensou
