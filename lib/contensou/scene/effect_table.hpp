#pragma once

#include <string>
#include <vector>

#include "contensou/scene/scene.hpp"

namespace contensou {

/// One thing that a scene can ask for: whether it did, and what therefore runs.
struct EffectRow {
  std::string where;   ///< "scene", "contact.NAME", "integrator"
  std::string effect;  ///< such as "gravity", "sliding friction"; of the integrator its settings
  bool runs = false;
  int rows = 0;     ///< of the contact problem that it adds to each contact: 1, 2 or 1 of at most 4
  std::string how;  ///< by what it is computed; where it does not run: why not
};

/// Everything that a scene could ask for, in the order scene, contacts, integrator; what is not asked for is
/// a row that does not run, so that two scenes can be compared line by line.
std::vector<EffectRow> effect_rows(const Scene& scene);

/// "N T1 T2 tau", as far as the contact has them.
std::string row_names(const ContactScene& contact);

}  // namespace contensou
