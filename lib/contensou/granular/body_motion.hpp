#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "contensou/granular/decay.hpp"
#include "contensou/system/body_layout.hpp"

namespace contensou {

/// Velocity of the centre of mass and spin, in space.
struct Twist {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();      ///< [m/s]
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// How a body answers to impulses within a step: 1/m and I⁻¹ in space, each times φ₁ of its drag (the
/// impulse is spread over the step, and what it does decays, too). Zero where it does not answer.
struct Mobility {
  double linear = 0;                                  ///< [1/kg]
  Eigen::Matrix3d angular = Eigen::Matrix3d::Zero();  ///< [1/(kg m²)]
};

/// A body where the contacts of a step are looked at.
struct Pose {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond axes = Eigen::Quaterniond::Identity();
  double lead = 0;  ///< how long it moved on from the step's start to get there [s]
};

/// All bodies over one step: what they would do without contacts, and where they get with them.
///
/// Translation with linear drag: exact for forces that are constant over the step. Rotation: first Euler's
/// gyroscopic term (gyration.hpp; bodies whose moments are equal have none), then drag and torque as in
/// translation, about each principal axis. Loads are those in the middle of the step.
class BodyMotion {
 public:
  /// The layout outlives it.
  explicit BodyMotion(const BodyLayout& layout);

  /// Starts a step of length dt from `state`.
  void begin(const State& state, double dt);

  // Of each body, since begin(), and last of what stands still: planes.
  const std::vector<Pose>& pose() const { return pose_; }
  /// At the start; the spin after its gyroscopic part, which does no work.
  const std::vector<Twist>& before() const { return before_; }
  const std::vector<Twist>& free() const { return free_; }  ///< at the end, without contacts
  const std::vector<Mobility>& mobility() const { return mobility_; }

  /// Ends the step with the velocities `after`: moves `state` on to t + dt. A body moves with
  ///     untouched:        the exact mean velocity,
  ///     touched:          (u⁻ + u⁺)/2,    dragged:   u⁺.
  /// `excess` [J] of a dragged body: the work of gravity and loads over the way it moves farther than with
  /// the mean velocity. Adds to `work`, sized as works(): of drag, if any, and of each load.
  enum class Touch : char { untouched, touched, dragged };
  void end(const std::vector<Twist>& after, const std::vector<Touch>& touch, State& state,
           std::vector<double>& excess, std::vector<double>& work);

  std::size_t works() const { return (drag_ ? 1 : 0) + data_.loads.size(); }
  /// How far from its centre of mass a body's spheres reach [m].
  double extent(std::size_t body) const { return constants_[body].extent; }
  double smallest_radius(std::size_t body) const { return constants_[body].smallest_radius; }

 private:
  struct Constants {
    bool isotropic = false;  ///< free, with three equal moments
    double extent = 0;
    double smallest_radius = 0;
  };

  void begin_spin(std::size_t i, const State& state);
  /// Whether impulses change the body's spin.
  bool answers(std::size_t i) const;
  Eigen::Vector3d moved(std::size_t i, const Twist& after, Touch touch) const;
  double drag_work(std::size_t i, const Twist& after, Touch touch, const Eigen::Vector3d& way,
                   const Eigen::Vector3d& mean) const;
  void end_spin(std::size_t i, const Twist& after, Touch touch, State& state) const;

  const BodyLayout& layout_;
  const BodiesData& data_;
  bool drag_ = false;
  std::vector<Constants> constants_;
  double dt_ = 0;
  double t_ = 0;  ///< at the start of the step
  std::vector<Pose> pose_;
  std::vector<Twist> before_, free_;
  std::vector<Mobility> mobility_;
  std::vector<Eigen::Vector3d> force_, torque_;  ///< of gravity and loads; of loads; in space
  std::vector<Eigen::Vector3d> gyration_;  ///< turn in its axes by which ω₀ is ahead of ω₁ on average
  std::vector<Eigen::Vector3d> way_;       ///< of the last step [m]
  std::vector<double> factor_;             ///< of each load
};

}  // namespace contensou
