#pragma once

#include <cstddef>
#include <optional>

#include "contensou/scene/scene.hpp"

namespace contensou {

/// A constant contact radius [m] in the place of one that follows the load: that under the weight of the
/// lighter body of the first pair of spheres, or sphere and plane, that touches by this contact, LG03 (3.2).
/// None where the radius does not follow the load, or there is no gravity.
std::optional<double> radius_under_weight(const Scene& scene, std::size_t contact);

}  // namespace contensou
