#include "contensou/granular/body_motion.hpp"

#include <algorithm>
#include <limits>

#include "contensou/granular/gyration.hpp"

namespace contensou {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Contacts are looked at half a step ahead, where directions are exact to second order, unless a body gets
/// farther than this part of its smallest sphere until then: it could be on the far side of what it hits.
constexpr double longest_lead = 0.25;

Quaterniond turned_by(const Vector3d& angle) {
  const double size = angle.norm();
  if (size == 0) return Quaterniond::Identity();
  return Quaterniond(Eigen::AngleAxisd(size, angle / size));
}

}  // namespace

BodyMotion::BodyMotion(const BodyLayout& layout) : layout_(layout), data_(layout.data()) {
  for (const BodyData& body : data_.bodies) {
    Constants c;
    c.isotropic = body.inertia[0] == body.inertia[1] && body.inertia[1] == body.inertia[2];
    c.smallest_radius = std::numeric_limits<double>::infinity();
    for (const SphereData& sphere : body.spheres) {
      c.extent = std::max(c.extent, sphere.centre.norm());
      c.smallest_radius = std::min(c.smallest_radius, sphere.radius);
    }
    constants_.push_back(c);
    const bool turns = body.rotation == Rotation::free || body.rotation == Rotation::upright;
    drag_ = drag_ || body.drag.linear > 0 || (turns && body.drag.angular > 0);
  }
  pose_.resize(data_.bodies.size() + 1);
  before_.resize(data_.bodies.size() + 1);
  free_.resize(data_.bodies.size() + 1);
  mobility_.resize(data_.bodies.size() + 1);
  force_.resize(data_.bodies.size());
  torque_.resize(data_.bodies.size());
  gyration_.assign(data_.bodies.size(), Vector3d::Zero());
  way_.resize(data_.bodies.size());
  factor_.resize(data_.loads.size());
}

void BodyMotion::begin(const State& state, double dt) {
  dt_ = dt;
  t_ = state.t;
  for (std::size_t i = 0; i < data_.bodies.size(); ++i) {
    force_[i] = data_.bodies[i].mass * data_.gravity;
    torque_[i].setZero();
  }
  for (std::size_t k = 0; k < data_.loads.size(); ++k) {
    const LoadData& load = data_.loads[k];
    factor_[k] = load.course.at(t_ + dt / 2);
    force_[load.body] += factor_[k] * load.force;
    torque_[load.body] += factor_[k] * load.torque;
  }
  for (std::size_t i = 0; i < data_.bodies.size(); ++i) {
    const BodyData& body = data_.bodies[i];
    const Decay decay(body.drag.linear * dt / body.mass);
    before_[i].v = layout_.velocity(i, state.u);
    free_[i].v = decay.left * before_[i].v + dt * decay.first / body.mass * force_[i];
    mobility_[i].linear = decay.first / body.mass;
    begin_spin(i, state);
    pose_[i].position = layout_.position(i, state.q) + pose_[i].lead * before_[i].v;
  }
}

/// Spin and attitude.
void BodyMotion::begin_spin(std::size_t i, const State& state) {
  const BodyData& body = data_.bodies[i];
  const Constants& c = constants_[i];
  Pose& pose = pose_[i];
  Twist& before = before_[i];
  Twist& free = free_[i];
  pose.axes = layout_.orientation(i, t_, state.q);
  before.omega = layout_.spin(i, t_, state.q, state.u);
  const double way = (before.v.norm() + before.omega.norm() * c.extent) * dt_ / 2;
  pose.lead = way <= longest_lead * c.smallest_radius ? dt_ / 2 : 0;
  if (c.extent > 0 || (body.rotation == Rotation::free && !c.isotropic))
    pose.axes = turned_by(pose.lead * before.omega) * pose.axes;
  free.omega = before.omega;
  if (body.rotation == Rotation::none || body.rotation == Rotation::driven) return;

  if (body.rotation == Rotation::upright || c.isotropic) {
    const Decay decay(body.drag.angular * dt_ / body.inertia[2]);
    const double inverse = decay.first / body.inertia[2];
    if (body.rotation == Rotation::upright) {
      const Vector3d axis = body.orientation * Vector3d::UnitZ();
      free.omega = decay.left * before.omega + dt_ * inverse * axis.dot(torque_[i]) * axis;
      mobility_[i].angular = inverse * axis * axis.transpose();
    } else {
      free.omega = decay.left * before.omega + dt_ * inverse * torque_[i];
      mobility_[i].angular = inverse * Matrix3d::Identity();
    }
    return;
  }
  const Matrix3d axes = pose.axes.toRotationMatrix();
  const Vector3d start = state.u.segment<3>(layout_.first_velocity(i) + 3);
  const Vector3d turned = gyrated(body.inertia, start, dt_);
  const Vector3d torque = axes.transpose() * torque_[i];
  Vector3d end, inverse;
  for (int k = 0; k < 3; ++k) {
    const Decay decay(body.drag.angular * dt_ / body.inertia[k]);
    inverse[k] = decay.first / body.inertia[k];
    end[k] = decay.left * turned[k] + dt_ * inverse[k] * torque[k];
  }
  gyration_[i] = dt_ / 2 * (start - turned);
  before.omega = axes * turned;
  free.omega = axes * end;
  mobility_[i].angular = axes * inverse.asDiagonal() * axes.transpose();
}

void BodyMotion::end(const std::vector<Twist>& after, const std::vector<Touch>& touch, State& state,
                     std::vector<double>& excess, std::vector<double>& work) {
  for (std::size_t i = 0; i < data_.bodies.size(); ++i) {
    const Vector3d way = moved(i, after[i], touch[i]);
    const Vector3d mean = dt_ / 2 * (before_[i].v + after[i].v);
    excess[i] = touch[i] == Touch::dragged ? force_[i].dot(way - mean) : 0;
    if (drag_) work[0] += drag_work(i, after[i], touch[i], way, mean);
    state.q.segment<3>(layout_.first_coordinate(i)) += way;
    state.u.segment<3>(layout_.first_velocity(i)) = after[i].v;
    way_[i] = way;
    end_spin(i, after[i], touch[i], state);
  }
  for (std::size_t k = 0; k < data_.loads.size(); ++k) {
    const LoadData& load = data_.loads[k];
    const std::size_t i = load.body;
    double energy = load.force.dot(way_[i]);
    if (answers(i)) energy += dt_ / 2 * load.torque.dot(before_[i].omega + after[i].omega);
    work[(drag_ ? 1 : 0) + k] += factor_[k] * energy;
  }
  state.t = t_ + dt_;
}

bool BodyMotion::answers(std::size_t i) const {
  const Rotation rotation = data_.bodies[i].rotation;
  return rotation == Rotation::free || rotation == Rotation::upright;
}

Vector3d BodyMotion::moved(std::size_t i, const Twist& after, Touch touch) const {
  switch (touch) {
    case Touch::dragged:
      return dt_ * after.v;
    case Touch::touched:
      return dt_ / 2 * (before_[i].v + after.v);
    case Touch::untouched:
      break;
  }
  const BodyData& body = data_.bodies[i];
  const Decay decay(body.drag.linear * dt_ / body.mass);
  return dt_ * decay.first * before_[i].v + dt_ * dt_ * decay.second / body.mass * force_[i];
}

/// What is left of the change of kinetic energy when the work of all else is taken off.
double BodyMotion::drag_work(std::size_t i, const Twist& after, Touch touch, const Vector3d& way,
                             const Vector3d& mean) const {
  const BodyData& body = data_.bodies[i];
  if (!body.drag.any()) return 0;
  // Of a touched body forces work over the mean way: what it moves farther is `excess`.
  double work = -force_[i].dot(touch == Touch::untouched ? way : mean);
  work += body.mass / 2 * (after.v.squaredNorm() - before_[i].v.squaredNorm());
  if (touch != Touch::untouched && mobility_[i].linear > 0)
    work -= (after.v - free_[i].v).dot(before_[i].v + after.v) / (2 * mobility_[i].linear);
  if (!answers(i) || body.drag.angular == 0) return work;
  // In principal axes, about each of which drag is on its own.
  const Eigen::Matrix3d axes = pose_[i].axes.toRotationMatrix();
  const Vector3d start = axes.transpose() * before_[i].omega;
  const Vector3d free = axes.transpose() * free_[i].omega;
  const Vector3d end = axes.transpose() * after.omega;
  const Vector3d torque = axes.transpose() * torque_[i];
  for (int k = body.rotation == Rotation::upright ? 2 : 0; k < 3; ++k) {
    const double first = Decay(body.drag.angular * dt_ / body.inertia[k]).first;
    const double impulse = body.inertia[k] * (end[k] - start[k]) - dt_ * torque[k] -
                           body.inertia[k] / first * (end[k] - free[k]);
    work += impulse * (start[k] + end[k]) / 2;
  }
  return work;
}

void BodyMotion::end_spin(std::size_t i, const Twist& after, Touch touch, State& state) const {
  const BodyData& body = data_.bodies[i];
  if (!answers(i)) return;
  const Eigen::Index q = layout_.first_coordinate(i) + 3;
  const Eigen::Index u = layout_.first_velocity(i) + 3;
  const Vector3d mean = dt_ / 2 * (before_[i].omega + after.omega);
  const Vector3d turn = touch == Touch::dragged ? Vector3d(dt_ * after.omega) : mean;
  if (body.rotation == Rotation::upright) {
    const Vector3d axis = body.orientation * Vector3d::UnitZ();
    state.q[q] += axis.dot(turn);
    state.u[u] = axis.dot(after.omega);
    return;
  }
  Quaterniond axes(state.q[q], state.q[q + 1], state.q[q + 2], state.q[q + 3]);
  if (constants_[i].isotropic) {
    axes = (turned_by(turn) * axes).normalized();
    state.u.segment<3>(u) = axes.conjugate() * after.omega;
  } else {
    const Quaterniond back = pose_[i].axes.conjugate();
    axes = (axes * turned_by(back * turn + (touch == Touch::dragged ? Vector3d::Zero() : gyration_[i])))
               .normalized();
    state.u.segment<3>(u) = back * after.omega;
  }
  state.q.segment<4>(q) << axes.w(), axes.x(), axes.y(), axes.z();
}

}  // namespace contensou
