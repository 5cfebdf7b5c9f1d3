#include "contensou/system/ball_on_plane.hpp"

#include <cmath>
#include <numbers>

#include "contensou/system/require.hpp"

namespace contensou {
namespace {

void require_valid(const BallOnPlaneData& d) {
  constexpr auto system_name = "ball on plane";
  require(system_name, d.m > 0, "m", d.m, positive_number);
  require(system_name, d.r > 0, "r", d.r, positive_number);
  require(system_name, d.g >= 0, "g", d.g, nonnegative_number);
  require(system_name, std::abs(d.tilt) <= std::numbers::pi / 2, "tilt", d.tilt,
          "a number from -pi/2 to pi/2");
}

}  // namespace

BallOnPlane::BallOnPlane(const BallOnPlaneData& data, const SystemContact& contact)
    : MechanicalSystem({contact}),
      data_(data),
      inertia_(2 * data.m * data.r * data.r / 5),
      gravity_(data.g * std::sin(data.tilt), 0, -data.g * std::cos(data.tilt)),
      radius_(contact.radius),
      rows_(rows(contact.friction)) {
  require_valid(data_);
}

void BallOnPlane::coordinate_rates(ConstVector /*q*/, ConstVector u, VectorRef rates) const {
  rates = u.head<3>();
}

void BallOnPlane::coordinate_scales(VectorRef scales) const { scales.setConstant(length_scale()); }

void BallOnPlane::mass_matrix(ConstVector /*q*/, Eigen::Ref<Eigen::MatrixXd> mass) const {
  mass.setZero();
  mass.diagonal() << data_.m, data_.m, data_.m, inertia_, inertia_, inertia_;
}

void BallOnPlane::force(double /*t*/, ConstVector /*q*/, ConstVector /*u*/, VectorRef h) const {
  h.head<3>() = data_.m * gravity_;
  h.tail<3>().setZero();
}

void BallOnPlane::free_acceleration(double /*t*/, ConstVector /*q*/, ConstVector /*u*/, VectorRef a) const {
  a.head<3>() = gravity_;
  a.tail<3>().setZero();
}

double BallOnPlane::gap(std::size_t /*contact*/, double /*t*/, ConstVector q) const { return q[2] - data_.r; }

void BallOnPlane::contact_rows(std::size_t /*contact*/, double /*t*/, ConstVector /*q*/, ConstVector u,
                               ContactRows& rows) const {
  // Each row acts on one velocity of the centre, one of the spin, or on one of both.
  struct Row {
    int linear;  ///< index in u, or -1
    int angular;
    double arm;
  };
  const Row all[] = {{2, -1, 0}, {0, 4, -data_.r}, {1, 3, data_.r}, {-1, 5, radius_}};
  for (int k = 0; k < rows_; ++k) {
    const auto [linear, angular, arm] = all[k];
    rows.directions.col(k).setZero();
    rows.response.col(k).setZero();
    rows.velocity[k] = 0;
    rows.drift[k] = 0;
    if (linear >= 0) {
      rows.directions(linear, k) = 1;
      rows.response(linear, k) = 1 / data_.m;
      rows.velocity[k] += u[linear];
    }
    if (angular >= 0) {
      rows.directions(angular, k) = arm;
      rows.response(angular, k) = arm / inertia_;
      rows.velocity[k] += arm * u[angular];
    }
  }
}

double BallOnPlane::kinetic_energy(ConstVector /*q*/, ConstVector u) const {
  return (data_.m * u.head<3>().squaredNorm() + inertia_ * u.tail<3>().squaredNorm()) / 2;
}

double BallOnPlane::potential_energy(ConstVector q) const { return -data_.m * gravity_.dot(q.head<3>()); }

}  // namespace contensou
