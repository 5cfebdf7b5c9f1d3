#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace bench {

using Forces = std::span<const Eigen::Vector3d>;

/// One way, at one setting, to project on the friction ball of size 1.
struct ProjectionMethod {
  std::string name;
  std::string setting;
  std::string pressure;
  /// Projects every force into `nearest`, one after the other.
  std::function<void(Forces forces, std::span<Eigen::Vector3d> nearest)> project;
  /// The same as a chain: each force waits for the result before it.
  std::function<double(Forces forces)> chain;
  /// Border points evaluated: mean and maximum over the forces.
  std::function<std::pair<double, int>(Forces forces)> iterations;
};

/// Every method of the comparison, for the uniform and the Hertz pressure and for power:1.
std::vector<ProjectionMethod> projection_methods();

}  // namespace bench
