#pragma once

#include "contensou/scene/reader.hpp"
#include "contensou/scene/scene.hpp"

namespace contensou {

/// [top], [initial], the two contacts, gravity and formulation of a scene with system = "tippe_top".
TippeTopScene read_tippe_top(SceneReader& read);

/// Throws where the top would start within the floor.
void require_above_floor(const SceneReader& read, const TippeTopScene& scene);

}  // namespace contensou
