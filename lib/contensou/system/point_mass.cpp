#include "contensou/system/point_mass.hpp"

#include <cmath>
#include <numbers>

#include "contensou/system/require.hpp"

namespace contensou {
namespace {

constexpr auto system_name = "point mass";

void require_valid(const PointMassData& d, int contact_rows) {
  require(system_name, d.m > 0, "m", d.m, positive_number);
  require(system_name, d.g >= 0, "g", d.g, nonnegative_number);
  require(system_name, std::abs(d.tilt) <= std::numbers::pi / 2, "tilt", d.tilt,
          "a number from -pi/2 to pi/2");
  require(system_name, true, "force_x", d.force_x, finite_number);
  require(system_name, true, "force_y", d.force_y, finite_number);
  require(system_name, contact_rows <= 3, "rows of its contact", contact_rows,
          "1 or 3: a point does not spin");
}

}  // namespace

PointMass::PointMass(const PointMassData& data, const SystemContact& contact)
    : MechanicalSystem({contact}),
      data_(data),
      force_(data.force_x + data.m * data.g * std::sin(data.tilt), data.force_y,
             -data.m * data.g * std::cos(data.tilt)),
      acceleration_(force_ / data.m),
      rows_(rows(contact.friction)) {
  require_valid(data_, rows_);
}

void PointMass::mass_matrix(ConstVector /*q*/, Eigen::Ref<Eigen::MatrixXd> mass) const {
  mass.setZero();
  mass.diagonal().setConstant(data_.m);
}

void PointMass::force(double /*t*/, ConstVector /*q*/, ConstVector /*u*/, VectorRef h) const { h = force_; }

void PointMass::free_acceleration(double /*t*/, ConstVector /*q*/, ConstVector /*u*/, VectorRef a) const {
  a = acceleration_;
}

double PointMass::gap(std::size_t /*contact*/, double /*t*/, ConstVector q) const { return q[2]; }

void PointMass::contact_rows(std::size_t /*contact*/, double /*t*/, ConstVector /*q*/, ConstVector u,
                             ContactRows& rows) const {
  constexpr int axis_of_row[] = {2, 0, 1};
  for (int k = 0; k < rows_; ++k) {
    const int axis = axis_of_row[k];
    rows.directions.col(k) = Eigen::Vector3d::Unit(axis);
    rows.response.col(k) = Eigen::Vector3d::Unit(axis) / data_.m;
    rows.velocity[k] = u[axis];
    rows.drift[k] = 0;
  }
}

double PointMass::kinetic_energy(ConstVector /*q*/, ConstVector u) const {
  return data_.m * u.squaredNorm() / 2;
}

double PointMass::potential_energy(ConstVector q) const { return -force_.dot(q); }

}  // namespace contensou
