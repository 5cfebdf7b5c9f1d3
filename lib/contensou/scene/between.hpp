#pragma once

#include <string>
#include <vector>

#include "contensou/scene/reader.hpp"
#include "contensou/scene/scene.hpp"
#include "contensou/scene/surfaces.hpp"

namespace contensou {

/// Fills the table of rules: `between`, two names for each of the scene's contacts. Refuses names that do not
/// exist, pairs that cannot touch or cannot by this law, pairs that two contacts name, and with the method
/// that watches every pair more than it can.
void resolve_rules(const SceneReader& read, const std::vector<Surface>& surfaces,
                   const std::vector<std::vector<std::string>>& between, Method method, BodiesScene& scene);

/// Pairs that a method which is not nscd watches at most.
inline constexpr std::size_t most_pairs = 100;

/// What the contacts of a scene are called where every pair is one: as the rule, or RULE_1, RULE_2, ... where
/// it has several pairs. One entry a pair.
struct PairName {
  std::string name;
  std::size_t rule;
};
std::vector<PairName> pair_names(const BodiesScene& scene);

}  // namespace contensou
