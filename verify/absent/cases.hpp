#pragma once

#include <string>
#include <vector>

namespace verify::absent {

/// A short scene, run in two lengths: what the longer one runs more is what its steps cost.
struct CountedScene {
  std::string name;
  std::string method;
  std::string effect;  ///< what it lacks, in words; empty: nothing, it is a control
  std::string text;    ///< TOML
  double duration;     ///< of the shorter run [s]; the longer one is twice that
  /// Names of the code groups that have nothing to do in it, and of those that have.
  std::vector<std::string> absent, present;
};

/// Scenes that each lack one effect more than the next, by each kind of method.
std::vector<CountedScene> counted_scenes();

/// The last of them: one ball on a table, drilling friction and all.
CountedScene ball_with_patch(const std::string& method);

/// Balls that slide and spin on a table, too far apart to meet: `contensou` of `balls` touch it with drilling
/// friction, the others as points.
CountedScene balls_on_table(const std::string& method, int balls, int contensou);

}  // namespace verify::absent
