#include "contensou/granular/approach.hpp"

#include <algorithm>
#include <cmath>

namespace contensou {
namespace {

using Eigen::Vector3d;

/// The centre of a shape, seen from its body's centre of mass.
Vector3d arm_of(const Shape& shape, const Pose& pose) {
  return shape.centre.isZero(0) ? Vector3d::Zero() : Vector3d(pose.axes * shape.centre);
}

}  // namespace

void look_at(const PairList& list, const BodyMotion& motion, std::vector<Approach>& approach) {
  const std::vector<NearPair>& pairs = list.pairs();
  approach.resize(pairs.size());
  const std::size_t still = motion.pose().size() - 1;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const NearPair& pair = pairs[k];
    Approach& a = approach[k];
    const Shape& shape = list.shapes()[pair.first];
    const Pose& pose = motion.pose()[shape.body];
    a.arm = arm_of(shape, pose);
    const Vector3d centre = pose.position + a.arm;
    std::size_t second = still;
    double size = shape.size;
    double lead_way = 0;  // by how much the gap changed up to where it is looked at
    if (list.is_plane(pair)) {
      const PlaneData& plane = list.plane(pair);
      a.normal = plane.normal;
      a.gap = a.normal.dot(centre) - (plane.offset + shape.radius);
      a.other.setZero();
    } else {
      const Shape& other = list.shapes()[pair.second];
      second = other.body;
      size = std::min(size, other.size);
      const Pose& other_pose = motion.pose()[second];
      a.other = arm_of(other, other_pose);
      const Vector3d between = centre - (other_pose.position + a.other);
      const double distance = between.norm();
      a.normal = distance > 0 ? Vector3d(between / distance) : Vector3d::UnitZ();
      a.gap = distance - (shape.radius + other.radius);
      const Twist& twist = motion.before()[second];
      lead_way -= other_pose.lead * a.normal.dot(twist.v + twist.omega.cross(a.other));
      a.other += other.radius * a.normal;
    }
    const Twist& twist = motion.before()[shape.body];
    lead_way += pose.lead * a.normal.dot(twist.v + twist.omega.cross(a.arm));
    a.gap -= lead_way;
    a.touching = touching_part * size;
    if (!shape.base) a.arm -= shape.radius * a.normal;
    a.before = a.velocity(twist, motion.before()[second]);
    a.free = a.velocity(motion.free()[shape.body], motion.free()[second]);
  }
}

double normal_target(const Approach& a, double restitution, double dt) {
  constexpr double part = 0.1;
  double closing = 0;
  if (a.gap > a.touching) closing = -a.gap / dt;
  if (a.gap < -a.touching) closing = -part * (a.gap + a.touching) / dt;
  const double bounce = -restitution * a.before;
  const bool bounces = bounce > std::abs(a.free - a.before) && a.gap + dt * a.free <= 0;
  return bounces ? std::max(bounce, closing) : closing;
}

bool is_impact(const Approach& a) { return -a.before > std::abs(a.free - a.before); }

}  // namespace contensou
