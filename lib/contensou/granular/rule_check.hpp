#pragma once

#include "contensou/system/body_data.hpp"

namespace contensou {

/// Throws std::invalid_argument with one line for rules that surfaces which have them cannot obey: a base
/// with a rule for a sphere, or for a plane that is not across its body's third axis (to 1e-9); a base whose
/// contact radius is to follow the load; drilling friction where neither side can spin.
void require_valid_rules(const BodiesData& data);

}  // namespace contensou
