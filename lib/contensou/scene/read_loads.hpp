#pragma once

#include <string>
#include <vector>

#include "contensou/scene/reader.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// [load.NAME]; its body is still to be found.
LoadData read_load(SceneReader& read, const std::string& name);
/// Finds the body; refuses one that is not there, and a torque on one that it cannot turn.
void resolve_load(const SceneReader& read, const std::vector<BodyData>& bodies, const std::string& body,
                  LoadData& load);

}  // namespace contensou
