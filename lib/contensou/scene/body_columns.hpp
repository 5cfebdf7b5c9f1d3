#pragma once

#include <memory>
#include <string>
#include <vector>

#include "contensou/scene/columns.hpp"
#include "contensou/system/body_layout.hpp"

namespace contensou {

/// The columns that a scene of bodies has if it names none.
std::vector<std::string> body_columns(const BodiesScene& scene);
/// Whether there is such a column; `nscd` has none of those that look at a contact.
bool has_body_column(const BodiesScene& scene, bool nscd, const std::string& column);
std::string body_column_help();

/// What appends `names`; the layout refers to the data that are kept with it. `system`: for columns that look
/// at contacts; null for nscd. Throws std::invalid_argument for a name that there is not.
DescribeMotion describe_bodies(std::shared_ptr<const BodiesData> data,
                               std::shared_ptr<const MechanicalSystem> system,
                               const std::vector<std::string>& names);

}  // namespace contensou
