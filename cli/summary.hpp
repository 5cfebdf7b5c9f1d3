#pragma once

#include <string>

#include "contensou/scene/run.hpp"
#include "scene_options.hpp"

namespace cli {

/// summary.json: what was run and what came of it. Numbers that are not finite are null.
std::string summary(const Command& command, const contensou::Scene& scene, const contensou::Outcome& outcome);

}  // namespace cli
