#pragma once

#include "contensou/scene/read_balls.hpp"
#include "contensou/scene/reader.hpp"
#include "contensou/scene/scene.hpp"

namespace contensou {

/// A scene of bodies as its keys are written: names are not looked up yet, balls not made.
struct BodiesDraft {
  BodiesScene scene;
  std::vector<BallsScene> balls;
  std::vector<std::vector<std::string>> between;  ///< by contact
  std::vector<std::string> touching;              ///< by body; empty: not said
  std::vector<std::string> loaded;                ///< the body, by load
};

/// [body], [balls], [plane], [box], [contact], [load] and gravity of a scene with system = "bodies".
BodiesDraft read_bodies(SceneReader& read);

/// The scene, once it is known that all keys are there: names resolved, balls made, bodies put where they
/// touch. Refuses what does not fit together, a start with bodies in each other included.
BodiesScene resolve(const SceneReader& read, BodiesDraft draft, Method method);

}  // namespace contensou
