#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "contensou/scene/document.hpp"
#include "contensou/scene/scene.hpp"

namespace contensou {

/// A scene with one effect switched off or simplified: what `contensou effects --audit` compares with the
/// scene as it stands.
struct Variation {
  std::string effect;   ///< "friction", "restitution", "gravity", "method", ...; "scene" for the scene itself
  std::string variant;  ///< what became of it: "ellipsoid", "off", "10 times the step"
  std::string contacts;  ///< names of the contacts it is about; empty: none
  SceneDocument document;
  std::vector<std::string> options;  ///< the same as options of the program: "--set KEY=VALUE", "--unset KEY"
  /// Index of the variation it is compared with: 0, the scene itself, or where its method cannot do it, the
  /// scene under another method.
  std::size_t against = 0;
};

/// All variations of a scene, itself first. `scene` is what the document reads as. Of contacts, all at once,
/// and each alone where there are several:
///     friction     contensou → ellipsoid → uncoupled → coulomb → frictionless (and exact, where it is not)
///     pressure     hertz ↔ uniform; others → both
///     radius       by the load → constant, that under the body's weight
///     restitution  off
/// and gravity, drag, loads, fidelity off; tolerance times 100 or step times 2 and 10; another method. Keys
/// that a change leaves unused are unset, and so are outcomes and columns, which read_variation() takes from
/// the scene.
std::vector<Variation> variations(const SceneDocument& document, const Scene& scene);

/// The variation's scene with those of the outcomes and columns of `scene` that there are in it. Throws
/// SceneError where it cannot be.
Scene read_variation(const Variation& variation, const Scene& scene);

}  // namespace contensou
