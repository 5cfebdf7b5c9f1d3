#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "contensou/system/body_data.hpp"

namespace contensou {

/// Where a body touches: one of its spheres, or its base.
struct BodySide {
  std::size_t body = 0;
  std::optional<std::size_t> sphere;  ///< index in BodyData::spheres; not given: the base
  Eigen::Vector3d centre;             ///< of the sphere in the body's axes; of a base: 0
  double reach = 0;                   ///< how far it goes from there [m]: radius; height of a base
  double lever = 0;                   ///< arm of friction from there [m]: radius; of a base 0
};

/// Two surfaces that can touch, of a body and a plane or of two bodies.
struct BodyPair {
  std::size_t rule = 0;           ///< index in BodiesData::rules
  BodySide side;                  ///< pushed along +n
  std::optional<BodySide> other;  ///< pushed along −n; not given: the plane
  std::size_t plane = 0;          ///< index in BodiesData::planes, whose normal is n
};

/// All pairs that have a rule: rule after rule; of each those with planes first, in the order of bodies and
/// spheres. Throws std::invalid_argument with one line for pairs that a rule cannot be of: a base with what
/// is no plane across its third axis (to 1e-9), drilling friction where neither body can spin.
std::vector<BodyPair> body_pairs(const BodiesData& data);

/// The contact laws of these pairs: each its rule's, and where that follows the load with the pair's own
/// relative radius, r or r r'/(r + r'). Their names are those of their rules, with _1, _2, ... where a rule
/// has several. Throws std::invalid_argument with one line for a base whose contact radius is to follow the
/// load.
std::vector<SystemContact> pair_contacts(const BodiesData& data, const std::vector<BodyPair>& pairs);

}  // namespace contensou
