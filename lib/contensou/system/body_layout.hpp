#pragma once

#include <Eigen/Core>
#include <vector>

#include "contensou/integrate/motion.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// Where the coordinates and velocities of rigid bodies stand in q and u, body after body:
///     none:     q = (x, y, z),                  u = (v)
///     free:     q = (x, y, z, a, b, c, d),      u = (v, ω in the body's axes)
///     upright:  q = (x, y, z, φ),               u = (v, φ̇)     turned by φ about its third axis since t = 0
///     driven:   q = (x, y, z),                  u = (v)         turned by the given spin since t = 0
/// with v in space and a + bi + cj + dk the unit quaternion that takes the body's axes to space. Refers to
/// the data, which outlive it.
class BodyLayout {
 public:
  explicit BodyLayout(const BodiesData& data);

  const BodiesData& data() const { return *data_; }
  std::size_t bodies() const { return data_->bodies.size(); }
  Eigen::Index coordinates() const { return coordinates_; }
  Eigen::Index velocities() const { return velocities_; }
  Eigen::Index first_coordinate(std::size_t body) const { return first_coordinate_[body]; }
  Eigen::Index first_velocity(std::size_t body) const { return first_velocity_[body]; }
  static Eigen::Index coordinates(Rotation rotation);
  static Eigen::Index velocities(Rotation rotation);

  /// The state the data start with, at t = 0.
  State start() const;

  Eigen::Vector3d position(std::size_t body, ConstVector q) const;
  Eigen::Vector3d velocity(std::size_t body, ConstVector u) const;
  /// The body's axes in space.
  Eigen::Quaterniond orientation(std::size_t body, double t, ConstVector q) const;
  /// ω in space [rad/s].
  Eigen::Vector3d spin(std::size_t body, double t, ConstVector q, ConstVector u) const;

  double kinetic_energy(ConstVector u) const;    ///< [J]; of a driven body without its rotation
  double potential_energy(ConstVector q) const;  ///< [J], zero at x = 0

 private:
  const BodiesData* data_;
  std::vector<Eigen::Index> first_coordinate_, first_velocity_;
  Eigen::Index coordinates_ = 0, velocities_ = 0;
};

}  // namespace contensou
