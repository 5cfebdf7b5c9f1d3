#pragma once

#include <string>
#include <vector>

#include "contensou/scene/run.hpp"

namespace cli {

/// How a scene was run: its file, and what the command line changed in it.
struct Command {
  std::string scene;
  std::vector<std::string> set;    ///< KEY=VALUE
  std::vector<std::string> unset;  ///< KEY
};

/// summary.json: what was run and what came of it. Numbers that are not finite are null.
std::string summary(const Command& command, const contensou::Scene& scene, const contensou::Outcome& outcome);

}  // namespace cli
