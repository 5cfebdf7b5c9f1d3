#pragma once

#include <string>

#include "contensou/scene/reader.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// [body.NAME] with its spheres and its base; their surfaces are still to be numbered.
BodyData read_body(SceneReader& read, const std::string& name);

/// `velocity`, `linear_drag`: of every body.
void read_motion(SceneReader& read, const std::string& table, BodyData& body);

}  // namespace contensou
