#pragma once

#include "contensou/scene/reader.hpp"
#include "contensou/scene/scene.hpp"

namespace contensou {

/// [integrator], and what belongs to it: scene.duration, scene.fidelity, output.interval. To be called once
/// it is known whether the scene is one of bodies.
void read_integrator(SceneReader& read, Scene& scene);

}  // namespace contensou
