#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/scene/scene.hpp"

namespace contensou {

/// Appends a row's values of columns to it.
using DescribeMotion = std::function<void(const Sample&, std::vector<double>&)>;

/// The columns of a scene's trajectory: those it names, else the system's own choice (docs/scenes.md); then
/// what its outcomes look at besides.
std::vector<std::string> columns(const Scene& scene);
/// Whether a scene of this system, method and contacts has a column of this name.
bool has_column(const Scene& scene, const std::string& column);
/// What names there are, in a line, for messages.
std::string column_help(const Scene& scene);

/// What appends `names` for a tippe-top; throws std::invalid_argument for one that it does not have.
DescribeMotion describe_tippe_top(std::shared_ptr<const TippeTopModel> top,
                                  const std::vector<std::string>& names);

}  // namespace contensou
