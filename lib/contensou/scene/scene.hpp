#pragma once

#include <array>
#include <optional>
#include <string>

#include "contensou/integrate/motion.hpp"
#include "contensou/scene/document.hpp"
#include "contensou/system/tippe_top_model.hpp"

namespace contensou {

enum class ContactLaw { frictionless, coulomb, contensou };
const char* name(ContactLaw law);

/// [contact.NAME]: a contact as a scene describes it. What its law does not use is not set.
struct ContactScene {
  std::string name;
  ContactLaw law = ContactLaw::frictionless;
  std::string pressure;    ///< contensou: as pressure_exponent() takes it
  std::string model;       ///< contensou: "exact" | "ellipsoid"
  double mu = 0;           ///< coulomb, contensou: >= 0
  double radius = 0;       ///< contensou [m]; 0 stands for the limit R → 0, a Coulomb point contact
  double restitution = 0;  ///< 0 to 1

  /// 1, 3 or 4: what the contact costs, and whether there is a drilling torque (4).
  int rows() const;
};

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

/// A scene: validated, plain data, nothing of it computed yet.
struct Scene {
  std::string file;
  std::string name;
  double duration = 0;  ///< [s] > 0
  IntegratorOptions integrator;
  TippeTopScene top;
};

/// The most rows a trajectory may have, and the most steps a fixed-step method may be asked for: beyond them
/// a misplaced exponent is likelier than a wish.
inline constexpr double most_rows = 1e6;
inline constexpr double most_steps = 1e12;

/// What the keys of a scene are; README and scenes/tippe_top.toml show them at work.
///   [scene]         system = "tippe_top"; duration [s] > 0; gravity [m/s²] >= 0; name (else that of the
///   file);
///                   formulation = "axis" (if not given) | "euler"
///   [top]           mass [kg], i1, i3 [kg m²] > 0, i3 <= 2 i1; a1, a2 [m]; r1, r2 [m] > 0; all mandatory
///   [initial]       theta [rad]; psi_dot [rad/s]; z_s [m] or "contact"; all mandatory
///   [contact.body] [contact.tip]
///                   law = "frictionless" | "coulomb" | "contensou", mandatory; mu >= 0 mandatory for the
///                   last two; radius [m] >= 0 mandatory for the last, 0 being the limit of a Coulomb point
///                   contact; pressure ("hertz" if not given) and model ("exact" if not given, "ellipsoid")
///                   of the last; restitution 0 to 1 (0 if not given: impacts do not rebound)
///   [integrator]    method, mandatory; step [s] for those that have one; tolerance for the others; both may
///                   stand. solver_tolerance; r [kg] of the printed methods
///   [output]        interval [s]; not given: only start and end are written
/// Throws SceneError, one line, for what is missing, unknown, not used or makes no sense, a start within the
/// floor included.
Scene read_scene(const SceneDocument& document);

/// The keys above, a table of them a paragraph, for --help.
std::string scene_help();

}  // namespace contensou
