#include "contensou/system/tippe_top_axis.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace contensou {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

/// One column of rows.directions or rows.response.
void write(Eigen::Matrix<double, Eigen::Dynamic, 4>& matrix, int column, const Vector3d& linear,
           const Vector3d& angular) {
  matrix.block<3, 1>(0, column) = linear;
  matrix.block<3, 1>(3, column) = angular;
}

}  // namespace

TippeTopAxis::TippeTopAxis(const TippeTopData& data, const std::array<SystemContact, 2>& contacts)
    : TippeTopModel(data, contacts),
      inverse_m_(1 / data.m),
      inverse_i1_(1 / data.i1),
      axial_(1 / data.i3 - 1 / data.i1) {}

void TippeTopAxis::coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const {
  const Vector3d e = q.tail<3>();
  const Vector3d omega = u.tail<3>();
  rates.head<3>() = u.head<3>();
  rates.tail<3>() = omega.cross(e);
}

void TippeTopAxis::restore(VectorRef q) const {
  const double excess = q.tail<3>().squaredNorm() - 1;
  if (std::abs(excess) > 4 * std::numeric_limits<double>::epsilon()) q.tail<3>().normalize();
}

void TippeTopAxis::mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const {
  const Vector3d e = q.tail<3>();
  mass.setZero();
  mass.diagonal() << data().m, data().m, data().m, data().i1, data().i1, data().i1;
  const Eigen::Matrix3d dyad = e * e.transpose();  // symmetric to the last bit
  mass.bottomRightCorner<3, 3>() += (data().i3 - data().i1) * dyad;
}

void TippeTopAxis::force(double /*t*/, ConstVector q, ConstVector u, VectorRef h) const {
  const Vector3d e = q.tail<3>();
  const Vector3d omega = u.tail<3>();
  h.head<3>() << 0, 0, -data().m * data().g;
  h.tail<3>() = (data().i1 - data().i3) * omega.dot(e) * omega.cross(e);
}

void TippeTopAxis::free_acceleration(double /*t*/, ConstVector q, ConstVector u, VectorRef a) const {
  const Vector3d e = q.tail<3>();
  const Vector3d omega = u.tail<3>();
  a.head<3>() << 0, 0, -data().g;
  a.tail<3>() = (data().i1 - data().i3) * inverse_i1_ * omega.dot(e) * omega.cross(e);
}

double TippeTopAxis::gap(std::size_t contact, double /*t*/, ConstVector q) const {
  return gap_at(contact, q[2], q[5]);
}

void TippeTopAxis::contact_rows(std::size_t contact, double /*t*/, ConstVector q, ConstVector u,
                                ContactRows& rows) const {
  const Sphere& c = sphere(contact);
  const Vector3d e = q.tail<3>();
  const Vector3d omega = u.tail<3>();
  const Vector3d s(c.a * e[0], c.a * e[1], c.a * e[2] - c.r);

  // The lever arms s × e_k are not all across the axis: e·(s × e_k) = −r e·(e_3 × e_k).
  const Vector3d normal(s[1], -s[0], 0);
  write(rows.directions, 0, Vector3d(0, 0, 1), normal);
  write(rows.response, 0, Vector3d(0, 0, inverse_m_), inverse_i1_ * normal);
  rows.velocity[0] = u[2] + omega.dot(normal);
  const Vector3d turn = c.a * (omega * omega.dot(e) - e * omega.squaredNorm());  // ω × ṡ, ṡ = a ω × e
  rows.drift[0] = turn[2];
  if (c.rows == 1) return;

  const Vector3d first(0, s[2], -s[1]);
  write(rows.directions, 1, Vector3d(1, 0, 0), first);
  write(rows.response, 1, Vector3d(inverse_m_, 0, 0), inverse_i1_ * first - axial_ * c.r * e[1] * e);
  rows.velocity[1] = u[0] + omega.dot(first);
  rows.drift[1] = turn[0];
  const Vector3d second(-s[2], 0, s[0]);
  write(rows.directions, 2, Vector3d(0, 1, 0), second);
  write(rows.response, 2, Vector3d(0, inverse_m_, 0), inverse_i1_ * second + axial_ * c.r * e[0] * e);
  rows.velocity[2] = u[1] + omega.dot(second);
  rows.drift[2] = turn[1];
  if (c.rows == 3) return;

  const Vector3d about(0, 0, c.radius);
  write(rows.directions, 3, Vector3d::Zero(), about);
  write(rows.response, 3, Vector3d::Zero(), inverse_i1_ * about + axial_ * c.radius * e[2] * e);
  rows.velocity[3] = c.radius * omega[2];
  rows.drift[3] = 0;
}

double TippeTopAxis::kinetic_energy(ConstVector q, ConstVector u) const {
  const Vector3d omega = u.tail<3>();
  const double along = omega.dot(q.tail<3>());
  return (data().m * u.head<3>().squaredNorm() + data().i1 * omega.squaredNorm() +
          (data().i3 - data().i1) * along * along) /
         2;
}

double TippeTopAxis::potential_energy(ConstVector q) const { return data().m * data().g * q[2]; }

State TippeTopAxis::start(double theta, double psi_dot, std::optional<double> z_s) const {
  State state{0, Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
  state.q[2] = starting_height(theta, psi_dot, z_s);
  state.q.tail<3>() << 0, -std::sin(theta), std::cos(theta);
  state.u.tail<3>() = psi_dot * state.q.tail<3>();
  return state;
}

double TippeTopAxis::inclination(ConstVector q) const { return std::atan2(std::hypot(q[3], q[4]), q[5]); }

Eigen::Vector3d TippeTopAxis::spin(ConstVector /*q*/, ConstVector u) const { return u.tail<3>(); }

}  // namespace contensou
