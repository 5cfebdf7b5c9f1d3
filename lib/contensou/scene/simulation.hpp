#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contensou/scene/scene.hpp"

namespace contensou {

/// The friction of a contact with the rows its law asks for.
AnyFriction make_friction(const ContactScene& contact);
/// The top of a scene in the formulation it asks for; throws std::invalid_argument for data that make no
/// sense.
std::unique_ptr<const TippeTopModel> make_tippe_top(const TippeTopScene& scene);

/// A scene ready to run: what it is composed of, and nothing else.
struct Simulation {
  std::unique_ptr<const MechanicalSystem> system;
  State state;
  double t_end;  ///< [s]
  IntegratorOptions options;
  /// What a row of the trajectory tells of the motion besides t and the contacts' modes: names, and the
  /// function that appends the values.
  std::vector<std::string> columns;
  std::function<void(const Sample&, std::vector<double>&)> describe;
};

/// Throws std::invalid_argument with one line where the scene makes no sense (read_scene() lets none through
/// that does not).
Simulation compose(const Scene& scene);

/// What runs, by name: "gravity", "unilateral contact", "restitution", "sliding friction", "drilling
/// friction". Drilling friction is always coupled with sliding friction: the friction ball is one set.
std::vector<std::string> effects(const ContactScene& contact);
std::vector<std::string> effects(const Scene& scene);

}  // namespace contensou
