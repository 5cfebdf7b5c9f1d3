#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contensou/scene/grid.hpp"
#include "scene_options.hpp"
#include "sweep_file.hpp"

namespace cli {

/// A scene and the runs that are made of it.
struct Study {
  contensou::SceneDocument document;
  contensou::Grid grid;
  std::vector<std::string> outcomes;  ///< names, the same in every run
  SweepHeader header;                 ///< of its table
};

/// Throws BadInput for what is wrong with the scene, the variations, or both at the first point of the grid.
Study make_study(const Command& command, const std::vector<std::string>& variations);

/// What is wrong with the scene of a run, in one line that names the run; nothing if all is well.
std::optional<std::string> complaint(const Study& study, std::size_t run);

/// Computes a run: its row of the table. A run that does not reach its end has its status there and no
/// outcomes (nan); so has one that is ended by an exception, by the status "error". Called by many threads.
std::string row(const Study& study, std::size_t run);

}  // namespace cli
