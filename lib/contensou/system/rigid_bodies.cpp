#include "contensou/system/rigid_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace contensou {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Of a length to the largest coordinate: what keeps the rounding of gaps, some 1e-16 of coordinates, well
/// below the gaps that integrators tell from zero, 1e-13 of length_scale().
constexpr double far = 32;

BodiesData normalised(BodiesData data) {
  require_valid(data);
  for (BodyData& body : data.bodies) body.orientation.normalize();
  for (PlaneData& plane : data.planes) plane.normal.normalize();
  return data;
}

/// From the centre of mass to the farthest point of a surface, or the radius of gyration.
double extent(const BodyData& body) {
  double reach = body.base ? body.base->height : 0;
  for (const SphereData& sphere : body.spheres) reach = std::max(reach, sphere.centre.norm() + sphere.radius);
  if (body.rotation == Rotation::free)
    reach = std::max(reach, std::sqrt(body.inertia.maxCoeff() / body.mass));
  if (body.rotation == Rotation::upright) reach = std::max(reach, std::sqrt(body.inertia[2] / body.mass));
  return reach;
}

}  // namespace

struct RigidBodies::Prepared {
  BodiesData data;
  std::vector<BodyPair> pairs;

  explicit Prepared(BodiesData given) : data(normalised(std::move(given))), pairs(body_pairs(data)) {}
};

RigidBodies::RigidBodies(BodiesData data) : RigidBodies(Prepared(std::move(data))) {}

RigidBodies::RigidBodies(Prepared prepared)
    : MechanicalSystem(pair_contacts(prepared.data, prepared.pairs)),
      data_(std::move(prepared.data)),
      layout_(data_),
      forces_(layout_),
      pairs_(std::move(prepared.pairs)) {
  for (std::size_t i = 0; i < data_.bodies.size(); ++i) {
    const BodyData& body = data_.bodies[i];
    bodies_.push_back({body.rotation, layout_.first_velocity(i), 1 / body.mass, body.inertia.cwiseInverse(),
                       body.orientation * Vector3d::UnitZ(), 1 / body.inertia[2]});
    if (body.rotation == Rotation::free) quaternions_.push_back(layout_.first_coordinate(i) + 3);
    driven_ = driven_ || (body.rotation == Rotation::driven && !body.spin.isZero(0));
  }
  for (const PlaneData& plane : data_.planes) plane_axes_.push_back(contact_axes(plane.normal));
  for (const SystemContact& contact : contacts()) rows_.push_back(contensou::rows(contact.friction));
  set_length();
}

void RigidBodies::set_length() {
  double length = 0, distance = 0;
  for (const BodyData& body : data_.bodies) {
    length = std::max(length, extent(body));
    distance = std::max(distance, body.position.lpNorm<Eigen::Infinity>());
  }
  for (const PlaneData& plane : data_.planes) distance = std::max(distance, std::abs(plane.offset));
  length = std::max(length, distance / far);
  if (length > 0) length_ = length;
}

void RigidBodies::coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Index to = layout_.first_coordinate(i);
    const Index from = bodies_[i].first;
    rates.segment<3>(to) = u.segment<3>(from);
    if (bodies_[i].rotation == Rotation::upright) rates[to + 3] = u[from + 3];
    if (bodies_[i].rotation != Rotation::free) continue;
    const Vector3d omega = u.segment<3>(from + 3) / 2;
    const Vector3d vector = q.segment<3>(to + 4);
    rates[to + 3] = -vector.dot(omega);
    rates.segment<3>(to + 4) = q[to + 3] * omega + vector.cross(omega);
  }
}

void RigidBodies::restore(VectorRef q) const {
  for (const Index first : quaternions_) {
    const double excess = q.segment<4>(first).squaredNorm() - 1;
    if (std::abs(excess) > 4 * std::numeric_limits<double>::epsilon()) q.segment<4>(first).normalize();
  }
}

void RigidBodies::coordinate_scales(VectorRef scales) const {
  scales.setOnes();
  for (std::size_t i = 0; i < bodies_.size(); ++i)
    scales.segment<3>(layout_.first_coordinate(i)).setConstant(length_);
}

void RigidBodies::mass_matrix(ConstVector /*q*/, Eigen::Ref<Eigen::MatrixXd> mass) const {
  mass.setZero();
  mass.diagonal() = forces_.mass();
}

void RigidBodies::force(double t, ConstVector q, ConstVector u, VectorRef h) const {
  forces_.acceleration(t, q, u, h);
  h.array() *= forces_.mass().array();
}

void RigidBodies::free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const {
  forces_.acceleration(t, q, u, a);
}

void RigidBodies::powers(double t, ConstVector q, ConstVector u, VectorRef power) const {
  forces_.powers(t, q, u, power);
}

double RigidBodies::kinetic_energy(ConstVector /*q*/, ConstVector u) const {
  return layout_.kinetic_energy(u);
}

double RigidBodies::potential_energy(ConstVector q) const { return layout_.potential_energy(q); }

/// A sphere in the centre of mass needs no attitude.
Vector3d RigidBodies::centre(const BodySide& side, double t, ConstVector q) const {
  Vector3d x = layout_.position(side.body, q);
  if (!side.centre.isZero(0)) x += layout_.orientation(side.body, t, q).toRotationMatrix() * side.centre;
  return x;
}

double RigidBodies::gap(std::size_t contact, double t, ConstVector q) const {
  const BodyPair& pair = pairs_[contact];
  const Vector3d x = centre(pair.side, t, q);
  if (pair.other) return sphere_gap(x, pair.side.reach, centre(*pair.other, t, q), pair.other->reach);
  const PlaneData& plane = data_.planes[pair.plane];
  return plane.normal.dot(x) - (plane.offset + pair.side.reach);
}

RigidBodies::Instant RigidBodies::instant(const BodySide& side, double t, ConstVector q,
                                          ConstVector u) const {
  Instant now;
  MovingSphere& sphere = now.sphere;
  now.velocity = layout_.velocity(side.body, u);
  sphere.radius = side.lever;
  const bool centred = side.centre.isZero(0);
  if (bodies_[side.body].rotation == Rotation::free) {
    now.attitude = layout_.orientation(side.body, t, q).toRotationMatrix();
    sphere.spin = now.attitude * u.segment<3>(bodies_[side.body].first + 3);
    if (!centred) sphere.arm = now.attitude * side.centre;
  } else {
    sphere.spin = layout_.spin(side.body, t, q, u);
    if (!centred) sphere.arm = layout_.orientation(side.body, t, q) * side.centre;
  }
  if (centred) {
    sphere.arm.setZero();
    sphere.velocity = now.velocity;
    sphere.acceleration.setZero();
  } else {
    const Vector3d turning = sphere.spin.cross(sphere.arm);
    sphere.velocity = now.velocity + turning;
    sphere.acceleration = sphere.spin.cross(turning);
  }
  sphere.centre = layout_.position(side.body, q) + sphere.arm;
  return now;
}

/// Adds sign·(axis_k acting at `lever`) to the rows k < 3, and sign·R n as a torque to the last one.
void RigidBodies::add(const BodySide& side, const Instant& now, const Part& part, ContactRows& rows) const {
  const Body& body = bodies_[side.body];
  for (int k = 0; k < part.rows; ++k) {
    Vector3d torque;
    if (k < 3) {
      const Vector3d push = part.sign * part.axes.col(k);
      torque = part.lever.cross(push);
      rows.directions.block<3, 1>(body.first, k) = push;
      rows.response.block<3, 1>(body.first, k) = body.inverse_mass * push;
      rows.velocity[k] += push.dot(now.velocity);
    } else {
      torque = part.sign * part.radius * part.axes.col(0);
    }
    rows.velocity[k] += torque.dot(now.sphere.spin);
    if (body.rotation == Rotation::free) {
      const Vector3d turned = now.attitude.transpose() * torque;
      rows.directions.block<3, 1>(body.first + 3, k) = turned;
      rows.response.block<3, 1>(body.first + 3, k) = body.inverse_inertia.cwiseProduct(turned);
    } else if (body.rotation == Rotation::upright) {
      const double along = body.axis.dot(torque);
      rows.directions(body.first + 3, k) = along;
      rows.response(body.first + 3, k) = body.inverse_axial * along;
    }
  }
}

void RigidBodies::contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                               ContactRows& rows) const {
  const BodyPair& pair = pairs_[contact];
  const int count = rows_[contact];
  const double radius = contacts()[contact].radius;
  rows.directions.leftCols(count).setZero();
  rows.response.leftCols(count).setZero();
  rows.velocity.head(count).setZero();
  const Instant side = instant(pair.side, t, q, u);
  Eigen::Vector4d drift;
  if (pair.other) {
    const Instant other = instant(*pair.other, t, q, u);
    const SphereContact geometry = sphere_contact(side.sphere, other.sphere, count > 1);
    add(pair.side, side, {1, geometry.lever, geometry.axes, radius, count}, rows);
    add(*pair.other, other, {-1, geometry.other, geometry.axes, radius, count}, rows);
    drift << geometry.drift, radius * geometry.spin_drift;
  } else {
    const Matrix3d& axes = plane_axes_[pair.plane];
    const Vector3d lever = side.sphere.arm - pair.side.lever * axes.col(0);
    add(pair.side, side, {1, lever, axes, radius, count}, rows);
    drift << axes.transpose() * side.sphere.acceleration, 0;
  }
  rows.drift.head(count) = drift.head(count);
}

}  // namespace contensou
