#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

/// What a rigid body may turn.
enum class Rotation {
  none,     ///< it only moves, a point with mass: no inertia, no spin
  free,     ///< about any axis: Euler's equations in principal axes
  upright,  ///< about its third axis alone, which keeps its direction in space: a body that lies flat
  driven,   ///< as it is told: constant angular velocity in space, whatever torque that takes
};

/// A sphere that belongs to a body.
struct SphereData {
  std::string name;         ///< "BODY.SPHERE" in messages
  Eigen::Vector3d centre;   ///< from the centre of mass, in the body's axes [m]
  double radius = 0;        ///< [m] > 0
  std::size_t surface = 0;  ///< index in BodiesData::rule
};

/// The flat round base of an upright or driven body: across its third axis, below the centre of mass. It
/// meets planes only, and those only whose normal is the third axis.
struct BaseData {
  std::string name;   ///< "BODY.base" in messages
  double height = 0;  ///< of the centre of mass above the base [m] >= 0
  std::size_t surface = 0;
};

/// Resistance of the air, linear and isotropic: −c_v v and −c_ω ω. Zero: there is none.
struct DragData {
  double linear = 0;   ///< c_v [N s/m] >= 0
  double angular = 0;  ///< c_ω [N m s] >= 0

  bool any() const { return linear > 0 || angular > 0; }
};

/// A rigid body, and how it starts. Axes of the body: principal, origin in the centre of mass.
struct BodyData {
  std::string name;
  Rotation rotation = Rotation::none;
  double mass = 0;  ///< [kg] > 0
  /// Principal moments [kg m²], each > 0 and at most the sum of the others; upright: the third alone counts;
  /// none, driven: unused.
  Eigen::Vector3d inertia = Eigen::Vector3d::Zero();
  DragData drag;
  std::vector<SphereData> spheres;
  std::optional<BaseData> base;

  Eigen::Vector3d position = Eigen::Vector3d::Zero();               ///< of the centre of mass [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< unit: takes the body's axes to space
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();               ///< [m/s]
  /// In space [rad/s]; upright: along the third axis; driven: for ever; none: zero.
  Eigen::Vector3d spin = Eigen::Vector3d::Zero();
};

/// A fixed plane: normal·x >= offset is outside.
struct PlaneData {
  std::string name;
  Eigen::Vector3d normal;  ///< unit, outward
  double offset = 0;       ///< [m]
  std::size_t surface = 0;
};

/// How a load goes with time: what the points (times, factors) say, linear between them and constant before
/// and after, times cos(2π frequency t + phase). Without points: 1.
struct CourseData {
  std::vector<double> times;    ///< [s], strictly increasing
  std::vector<double> factors;  ///< as many
  double frequency = 0;         ///< [Hz] >= 0
  double phase = 0;             ///< [rad]

  double at(double t) const;
  bool constant() const { return times.empty() && frequency == 0 && phase == 0; }
};

/// A force on the centre of mass and a torque, in space, both times the course.
struct LoadData {
  std::string name;
  std::size_t body = 0;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N m]
  CourseData course;
};

/// Rigid bodies among fixed planes: everything that is there and nothing else. Which surfaces can touch is
/// said by rules, one contact law each; surfaces without a rule pass through each other.
struct BodiesData {
  static constexpr int no_rule = -1;

  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< [m/s²]; zero: there is none
  std::vector<BodyData> bodies;
  std::vector<PlaneData> planes;
  std::vector<LoadData> loads;
  std::vector<SystemContact> rules;  ///< contact laws
  /// Surface × surface, symmetric: the rule by which they touch, or no_rule. Spheres of one body never touch
  /// each other.
  Eigen::ArrayXXi rule;

  const SystemContact* between(std::size_t a, std::size_t b) const {
    const int r = rule(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    return r == no_rule ? nullptr : &rules[static_cast<std::size_t>(r)];
  }
};

/// Throws std::invalid_argument with one line that names the body, plane or load and what is wrong with it:
/// masses, moments of inertia, radii, unit vectors and quaternions, indices, sizes, numbers that are not
/// finite. Not whether bodies overlap: that is for who starts the motion.
void require_valid(const BodiesData& data);

}  // namespace contensou
