#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/scene/contact_scene.hpp"
#include "contensou/scene/document.hpp"
#include "contensou/scene/measure.hpp"
#include "contensou/system/body_data.hpp"
#include "contensou/system/tippe_top_model.hpp"

namespace contensou {

/// [top] and [initial] of a scene with system = "tippe_top", LG03 Section 5.
struct TippeTopScene {
  enum class Formulation { axis, euler };
  Formulation formulation = Formulation::axis;
  TippeTopData data;                     ///< g is the scene's gravity
  double theta = 0;                      ///< [rad] 0 to π; both excluded for euler
  double psi_dot = 0;                    ///< [rad/s]
  std::optional<double> z_s;             ///< [m]; not given: the lower contact just touches
  std::array<ContactScene, 2> contacts;  ///< body, tip
};

/// A scene with system = "bodies": rigid bodies among fixed planes, docs/scenes.md.
struct BodiesScene {
  BodiesData data;                     ///< all but `rules`, which are made from `contacts`
  std::vector<ContactScene> contacts;  ///< the rules, in the order of their indices
};

/// A scene: validated, plain data, nothing of it computed yet.
struct Scene {
  std::string file;
  std::string name;
  double duration = 0;  ///< [s] > 0
  IntegratorOptions integrator;
  int threads = 1;  ///< nscd: how many it may use; the result does not depend on it
  /// `fidelity`: what may be left out for being smaller than this part of the scene's size; not given:
  /// nothing.
  std::optional<double> fidelity;
  std::variant<TippeTopScene, BodiesScene> system;
  std::vector<std::string> columns;    ///< [output] columns: of the trajectory; empty: a choice by the system
  std::vector<MeasureScene> measures;  ///< [outcome.NAME]: what the scene is about, in numbers

  /// The contacts' laws, in the order of contact indices in events and dissipation.
  std::vector<const ContactScene*> contacts() const;
};

/// The most rows a trajectory may have, the most numbers in them, and the most steps a fixed-step method may
/// be asked for: beyond them a misplaced exponent is likelier than a wish.
inline constexpr double most_rows = 1e6;
inline constexpr double most_numbers = 1e8;
inline constexpr double most_steps = 1e12;

/// Reads a scene; what its keys are says docs/scenes.md. Throws SceneError, one line, for what is missing,
/// unknown, not used or makes no sense, a start with bodies in each other or in a plane included.
Scene read_scene(const SceneDocument& document);

/// The keys, a table of them a paragraph, for --help.
std::string scene_help();

}  // namespace contensou
