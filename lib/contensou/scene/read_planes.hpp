#pragma once

#include <string>
#include <vector>

#include "contensou/scene/reader.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// [plane.NAME].
PlaneData read_plane(SceneReader& read, const std::string& name);
/// [box.NAME]: its sides as planes NAME.bottom and so on.
std::vector<PlaneData> read_box(SceneReader& read, const std::string& name);

}  // namespace contensou
