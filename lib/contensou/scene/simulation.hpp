#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/scene/scene.hpp"

namespace contensou {

/// The top of a scene in the formulation it asks for; throws std::invalid_argument for data that make no
/// sense.
std::unique_ptr<const TippeTopModel> make_tippe_top(const TippeTopScene& scene);

/// A scene ready to run: what it is composed of, and nothing else. Copies run apart from each other: all that
/// they share is immutable.
struct Simulation {
  /// What moves; null for nscd, which knows bodies only.
  std::shared_ptr<const MechanicalSystem> system;
  State state{};
  double t_end = 0;  ///< [s]
  IntegratorOptions options;
  /// As integrate() for this scene.
  std::function<RunReport(State&, double t_end, const IntegratorOptions&, const Observer&)> advance;
  std::vector<std::string> contacts;  ///< names, in the order of indices in the report
  std::vector<std::string> works;     ///< names of RunReport::work
  /// What a row of the trajectory tells of the motion besides t and the contacts' modes: names, and the
  /// function that appends the values.
  std::vector<std::string> columns;
  std::function<void(const Sample&, std::vector<double>&)> describe;
  std::function<double(const State&)> energy;  ///< kinetic and potential [J]
};

/// Throws std::invalid_argument with one line where the scene makes no sense (read_scene() lets none through
/// that does not).
Simulation compose(const Scene& scene);

}  // namespace contensou
