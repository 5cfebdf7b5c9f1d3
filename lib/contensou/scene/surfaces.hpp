#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <vector>

#include "contensou/system/body_data.hpp"

namespace contensou {

/// A kind of surface: what has its index in BodiesData::rule. A sphere, a base or a plane of its own, or all
/// balls of one [balls.NAME].
struct Surface {
  enum class Kind { sphere, balls, base, plane };
  std::string name;   ///< "top.tip", "puck.base", "balls", "floor", "box.west"
  std::string owner;  ///< "top", "puck", "balls", "floor", "box": stands for all its surfaces
  Kind kind = Kind::sphere;
  std::size_t first = 0;  ///< index of the body, of the first of the balls, or of the plane
  std::size_t count = 1;  ///< of bodies

  bool is_of_bodies() const { return kind != Kind::plane; }
};

/// Numbers the surfaces: of bodies, then of balls (`balls` of them, in groups of these sizes, at the end of
/// the bodies), then of planes. Writes the numbers into the data.
std::vector<Surface> number_surfaces(BodiesData& data, const std::vector<std::size_t>& balls);

/// The indices of the surfaces of this name or this owner.
std::vector<std::size_t> named(const std::vector<Surface>& surfaces, const std::string& name);
/// The names that there are, for a message.
std::string owners(const std::vector<Surface>& surfaces);

/// How many pairs of surfaces have each rule: what a method that watches every pair has to watch.
std::vector<std::size_t> count_pairs(const BodiesData& data, std::size_t rules);

}  // namespace contensou
