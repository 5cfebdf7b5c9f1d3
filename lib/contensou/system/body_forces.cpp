#include "contensou/system/body_forces.hpp"

#include <Eigen/Geometry>

namespace contensou {

using Eigen::Index;
using Eigen::Vector3d;

BodyForces::BodyForces(const BodyLayout& layout)
    : layout_(layout),
      mass_(layout.velocities()),
      inverse_mass_(layout.velocities()),
      constant_(Eigen::VectorXd::Zero(layout.velocities())) {
  const BodiesData& data = layout.data();
  for (std::size_t i = 0; i < data.bodies.size(); ++i) add_body(data.bodies[i], layout.first_velocity(i));
  inverse_mass_ = mass_.cwiseInverse();
  for (Damped& damped : damped_) damped.rate = damped.constant * inverse_mass_[damped.index];
  if (!damped_.empty()) works_.emplace_back("air drag");
  for (const LoadData& load : data.loads) add_load(load);
}

void BodyForces::add_body(const BodyData& body, Index first) {
  mass_.segment<3>(first).setConstant(body.mass);
  constant_.segment<3>(first) = layout_.data().gravity;
  const auto damp = [&](Index begin, Index count, double constant) {
    for (Index k = 0; constant > 0 && k < count; ++k) damped_.push_back({begin + k, 0, constant});
  };
  damp(first, 3, body.drag.linear);
  const Index turning = BodyLayout::velocities(body.rotation) - 3;
  damp(first + 3, turning, body.drag.angular);
  if (body.rotation == Rotation::upright) mass_[first + 3] = body.inertia[2];
  if (body.rotation != Rotation::free) return;
  const Vector3d& i = body.inertia;
  mass_.segment<3>(first + 3) = i;
  // In differences of the moments: exactly zero where two of them are equal.
  const Vector3d k((i[1] - i[2]) / i[0], (i[2] - i[0]) / i[1], (i[0] - i[1]) / i[2]);
  if (!k.isZero(0)) gyroscopic_.push_back({first + 3, k});
}

void BodyForces::add_load(const LoadData& load) {
  works_.push_back("load " + load.name);
  const BodyData& body = layout_.data().bodies[load.body];
  const Index first = layout_.first_velocity(load.body);
  const bool constant = load.course.constant();
  if (!load.force.isZero(0)) {
    const Vector3d acceleration = load.force / body.mass;
    if (constant) {
      constant_.segment<3>(first) += acceleration;
    } else {
      pushes_.push_back({&load, first, acceleration});
    }
  }
  if (load.torque.isZero(0)) return;
  if (body.rotation == Rotation::upright) {
    const Vector3d axis = body.orientation * Vector3d::UnitZ();
    const double acceleration = axis.dot(load.torque) / body.inertia[2];
    if (constant) {
      constant_[first + 3] += acceleration;
    } else {
      spins_.push_back({&load, first + 3, acceleration});
    }
  }
  if (body.rotation == Rotation::free) twists_.push_back({&load, first + 3});
}

void BodyForces::acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const {
  a = constant_;
  for (const Gyroscopic& g : gyroscopic_) {
    const Vector3d omega = u.segment<3>(g.first);
    a.segment<3>(g.first) +=
        g.k.cwiseProduct(Vector3d(omega[1] * omega[2], omega[2] * omega[0], omega[0] * omega[1]));
  }
  for (const Damped& d : damped_) a[d.index] -= d.rate * u[d.index];
  for (const Push& push : pushes_) a.segment<3>(push.first) += push.load->course.at(t) * push.acceleration;
  for (const Spin& spin : spins_) a[spin.index] += spin.load->course.at(t) * spin.acceleration;
  for (const Twist& twist : twists_) {
    const Vector3d torque = layout_.orientation(twist.load->body, t, q).conjugate() * twist.load->torque;
    a.segment<3>(twist.first) +=
        twist.load->course.at(t) * torque.cwiseProduct(inverse_mass_.segment<3>(twist.first));
  }
}

void BodyForces::powers(double t, ConstVector q, ConstVector u, VectorRef power) const {
  Index account = 0;
  if (!damped_.empty()) {
    double drag = 0;
    for (const Damped& d : damped_) drag -= d.constant * u[d.index] * u[d.index];
    power[account++] = drag;
  }
  for (const LoadData& load : layout_.data().loads) {
    double rate = load.force.dot(layout_.velocity(load.body, u));
    if (!load.torque.isZero(0)) rate += load.torque.dot(layout_.spin(load.body, t, q, u));
    power[account++] = load.course.at(t) * rate;
  }
}

}  // namespace contensou
