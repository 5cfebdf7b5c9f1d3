#include "contensou/system/free_body.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contensou/system/body_limits.hpp"
#include "contensou/system/require.hpp"

namespace contensou {
namespace {

using Eigen::Vector3d;

constexpr auto system_name = "free body";

void require_valid(const FreeBodyData& d) {
  require(system_name, d.i1 > 0, "i1", d.i1, positive_number);
  require(system_name, d.i2 > 0, "i2", d.i2, positive_number);
  require(system_name, d.i3 > 0, "i3", d.i3, positive_number);
  require(system_name, at_most_sum(d.i1, d.i2, d.i3), "i1", d.i1, "at most i2 + i3");
  require(system_name, at_most_sum(d.i2, d.i3, d.i1), "i2", d.i2, "at most i3 + i1");
  require(system_name, at_most_sum(d.i3, d.i1, d.i2), "i3", d.i3, "at most i1 + i2");
}

}  // namespace

FreeBody::FreeBody(const FreeBodyData& data)
    : MechanicalSystem({}), data_(data), inertia_(data.i1, data.i2, data.i3) {
  require_valid(data_);
}

Eigen::Matrix3d FreeBody::attitude(ConstVector q) const {
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
}

Vector3d FreeBody::angular_momentum(ConstVector q, ConstVector u) const {
  return attitude(q) * inertia_.cwiseProduct(u.head<3>());
}

void FreeBody::coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const {
  const Vector3d omega = u.head<3>() / 2;
  const Vector3d vector = q.tail<3>();
  rates[0] = -vector.dot(omega);
  rates.tail<3>() = q[0] * omega + vector.cross(omega);
}

void FreeBody::restore(VectorRef q) const {
  const double excess = q.squaredNorm() - 1;
  if (std::abs(excess) > 4 * std::numeric_limits<double>::epsilon()) q.normalize();
}

void FreeBody::mass_matrix(ConstVector /*q*/, Eigen::Ref<Eigen::MatrixXd> mass) const {
  mass.setZero();
  mass.diagonal() = inertia_;
}

void FreeBody::force(double /*t*/, ConstVector /*q*/, ConstVector u, VectorRef h) const {
  // −ω × Mω in differences of the moments: exactly zero where two of them are equal
  h << (data_.i2 - data_.i3) * u[1] * u[2], (data_.i3 - data_.i1) * u[2] * u[0],
      (data_.i1 - data_.i2) * u[0] * u[1];
}

void FreeBody::free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const {
  force(t, q, u, a);
  a.array() /= inertia_.array();
}

double FreeBody::gap(std::size_t /*contact*/, double /*t*/, ConstVector /*q*/) const {
  throw std::out_of_range("free body: it has no contact");
}

void FreeBody::contact_rows(std::size_t /*contact*/, double /*t*/, ConstVector /*q*/, ConstVector /*u*/,
                            ContactRows& /*rows*/) const {
  throw std::out_of_range("free body: it has no contact");
}

double FreeBody::kinetic_energy(ConstVector /*q*/, ConstVector u) const {
  return inertia_.dot(u.cwiseAbs2()) / 2;
}

double FreeBody::potential_energy(ConstVector /*q*/) const { return 0; }

}  // namespace contensou
