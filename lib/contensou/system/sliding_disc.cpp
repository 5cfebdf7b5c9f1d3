#include "contensou/system/sliding_disc.hpp"

#include <cmath>

#include "contensou/system/require.hpp"

namespace contensou {

SlidingDisc::SlidingDisc(const SlidingDiscData& data, const SystemContact& contact)
    : MechanicalSystem({contact}), data_(data), radius_(contact.radius), rows_(rows(contact.friction)) {
  constexpr auto system_name = "sliding disc";
  require(system_name, data.m > 0, "m", data.m, positive_number);
  require(system_name, data.i > 0, "i", data.i, positive_number);
  require(system_name, data.g >= 0, "g", data.g, nonnegative_number);
}

double SlidingDisc::length_scale() const { return std::sqrt(data_.i / data_.m); }

void SlidingDisc::coordinate_scales(VectorRef scales) const {
  scales.head<3>().setConstant(length_scale());
  scales[3] = 1;
}

void SlidingDisc::mass_matrix(ConstVector /*q*/, Eigen::Ref<Eigen::MatrixXd> mass) const {
  mass.setZero();
  mass.diagonal() << data_.m, data_.m, data_.m, data_.i;
}

void SlidingDisc::force(double /*t*/, ConstVector /*q*/, ConstVector /*u*/, VectorRef h) const {
  h << 0, 0, -data_.m * data_.g, 0;
}

void SlidingDisc::free_acceleration(double /*t*/, ConstVector /*q*/, ConstVector /*u*/, VectorRef a) const {
  a << 0, 0, -data_.g, 0;
}

double SlidingDisc::gap(std::size_t /*contact*/, double /*t*/, ConstVector q) const { return q[2]; }

void SlidingDisc::contact_rows(std::size_t /*contact*/, double /*t*/, ConstVector /*q*/, ConstVector u,
                               ContactRows& rows) const {
  constexpr int coordinate_of_row[] = {2, 0, 1, 3};
  for (int k = 0; k < rows_; ++k) {
    const int i = coordinate_of_row[k];
    const double length = k == 3 ? radius_ : 1;
    rows.directions.col(k) = length * Eigen::Vector4d::Unit(i);
    rows.response.col(k) = length / (k == 3 ? data_.i : data_.m) * Eigen::Vector4d::Unit(i);
    rows.velocity[k] = length * u[i];
    rows.drift[k] = 0;
  }
}

double SlidingDisc::kinetic_energy(ConstVector /*q*/, ConstVector u) const {
  return (data_.m * u.head<3>().squaredNorm() + data_.i * u[3] * u[3]) / 2;
}

double SlidingDisc::potential_energy(ConstVector q) const { return data_.m * data_.g * q[2]; }

}  // namespace contensou
