#pragma once

#include <string>
#include <vector>

#include "contensou/scene/document.hpp"
#include "contensou/scene/scene.hpp"
#include "subcommand.hpp"

namespace cli {

/// Which scene, and what the command line changes in it.
struct Command {
  std::string scene;
  std::vector<std::string> set;    ///< KEY=VALUE
  std::vector<std::string> unset;  ///< KEY
};

/// Adds SCENE, --set and --unset.
void add_scene_options(CLI::App& subcommand, Command& command);

/// The scene's document with its changes. BadInput where it cannot be read or a change makes no sense.
contensou::SceneDocument changed_document(const Command& command);
/// The scene itself; BadInput, too, for what is wrong with it.
contensou::Scene changed_scene(const Command& command);

}  // namespace cli
