#pragma once

#include <string>
#include <vector>

#include "contensou/scene/reader.hpp"
#include "contensou/scene/surfaces.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// Moves a body along the normal of the plane that its `touching` names so that the first of its surfaces
/// that have a rule with the plane is at it. Refuses what is no plane, and a plane that it has no contact
/// with.
void place_touching(const SceneReader& read, const std::vector<Surface>& surfaces, const std::string& plane,
                    std::size_t body, BodiesData& data);

/// Refuses a start with surfaces that have a rule in each other: says which two and how deep. Balls of one
/// group are apart by their lattice. Time grows with the number of bodies, not with its square.
void require_apart(const SceneReader& read, const std::vector<Surface>& surfaces, const BodiesData& data);

}  // namespace contensou
