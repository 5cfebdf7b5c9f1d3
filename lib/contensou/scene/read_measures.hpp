#pragma once

#include "contensou/scene/reader.hpp"
#include "contensou/scene/scene.hpp"

namespace contensou {

/// [output] columns and [outcome.NAME].
void read_measures(SceneReader& read, Scene& scene);

/// Refuses columns, contacts and events that the scene does not have, once all of it is known.
void require_measurable(const SceneReader& read, const Scene& scene);

}  // namespace contensou
