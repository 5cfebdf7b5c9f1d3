#include "contensou/system/body_layout.hpp"

namespace contensou {
namespace {

/// A turn by the vector `angle` [rad].
Eigen::Quaterniond turn(const Eigen::Vector3d& angle) {
  const double size = angle.norm();
  if (size == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(size, angle / size));
}

}  // namespace

BodyLayout::BodyLayout(const BodiesData& data) : data_(&data) {
  for (const BodyData& body : data.bodies) {
    first_coordinate_.push_back(coordinates_);
    first_velocity_.push_back(velocities_);
    coordinates_ += coordinates(body.rotation);
    velocities_ += velocities(body.rotation);
  }
}

Eigen::Index BodyLayout::coordinates(Rotation rotation) {
  return rotation == Rotation::free ? 7 : rotation == Rotation::upright ? 4 : 3;
}

Eigen::Index BodyLayout::velocities(Rotation rotation) {
  return rotation == Rotation::free ? 6 : rotation == Rotation::upright ? 4 : 3;
}

State BodyLayout::start() const {
  State state{0, Eigen::VectorXd::Zero(coordinates_), Eigen::VectorXd::Zero(velocities_)};
  for (std::size_t i = 0; i < bodies(); ++i) {
    const BodyData& body = data_->bodies[i];
    state.q.segment<3>(first_coordinate_[i]) = body.position;
    state.u.segment<3>(first_velocity_[i]) = body.velocity;
    if (body.rotation == Rotation::free) {
      const Eigen::Quaterniond& p = body.orientation;
      state.q.segment<4>(first_coordinate_[i] + 3) << p.w(), p.x(), p.y(), p.z();
      state.u.segment<3>(first_velocity_[i] + 3) = p.conjugate() * body.spin;
    } else if (body.rotation == Rotation::upright) {
      state.u[first_velocity_[i] + 3] = (body.orientation * Eigen::Vector3d::UnitZ()).dot(body.spin);
    }
  }
  return state;
}

Eigen::Vector3d BodyLayout::position(std::size_t body, ConstVector q) const {
  return q.segment<3>(first_coordinate_[body]);
}

Eigen::Vector3d BodyLayout::velocity(std::size_t body, ConstVector u) const {
  return u.segment<3>(first_velocity_[body]);
}

Eigen::Quaterniond BodyLayout::orientation(std::size_t body, double t, ConstVector q) const {
  const BodyData& data = data_->bodies[body];
  const Eigen::Index first = first_coordinate_[body] + 3;
  switch (data.rotation) {
    case Rotation::free:
      return {q[first], q[first + 1], q[first + 2], q[first + 3]};
    case Rotation::upright:
      return data.orientation * turn({0, 0, q[first]});
    case Rotation::driven:
      return turn(t * data.spin) * data.orientation;
    case Rotation::none:
      break;
  }
  return data.orientation;
}

Eigen::Vector3d BodyLayout::spin(std::size_t body, double t, ConstVector q, ConstVector u) const {
  const BodyData& data = data_->bodies[body];
  const Eigen::Index first = first_velocity_[body] + 3;
  switch (data.rotation) {
    case Rotation::free:
      return orientation(body, t, q) * Eigen::Vector3d(u.segment<3>(first));
    case Rotation::upright:
      return data.orientation * Eigen::Vector3d(0, 0, u[first]);
    case Rotation::driven:
      return data.spin;
    case Rotation::none:
      break;
  }
  return Eigen::Vector3d::Zero();
}

double BodyLayout::kinetic_energy(ConstVector u) const {
  double twice = 0;
  for (std::size_t i = 0; i < bodies(); ++i) {
    const BodyData& body = data_->bodies[i];
    const Eigen::Index first = first_velocity_[i];
    twice += body.mass * u.segment<3>(first).squaredNorm();
    if (body.rotation == Rotation::free) twice += body.inertia.dot(u.segment<3>(first + 3).cwiseAbs2());
    if (body.rotation == Rotation::upright) twice += body.inertia[2] * u[first + 3] * u[first + 3];
  }
  return twice / 2;
}

double BodyLayout::potential_energy(ConstVector q) const {
  double energy = 0;
  for (std::size_t i = 0; i < bodies(); ++i)
    energy -= data_->bodies[i].mass * data_->gravity.dot(q.segment<3>(first_coordinate_[i]));
  return energy;
}

}  // namespace contensou
