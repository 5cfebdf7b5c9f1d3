#include "contensou/system/harmonic_oscillator.hpp"

#include <cmath>
#include <stdexcept>

#include "contensou/system/require.hpp"

namespace contensou {

HarmonicOscillator::HarmonicOscillator(const HarmonicOscillatorData& data)
    : MechanicalSystem({}), data_(data) {
  require("harmonic oscillator", data.m > 0, "m", data.m, positive_number);
  require("harmonic oscillator", data.k >= 0, "k", data.k, nonnegative_number);
}

double HarmonicOscillator::frequency() const { return std::sqrt(data_.k / data_.m); }

void HarmonicOscillator::mass_matrix(ConstVector /*q*/, Eigen::Ref<Eigen::MatrixXd> mass) const {
  mass(0, 0) = data_.m;
}

void HarmonicOscillator::force(double /*t*/, ConstVector q, ConstVector /*u*/, VectorRef h) const {
  h[0] = -data_.k * q[0];
}

void HarmonicOscillator::free_acceleration(double /*t*/, ConstVector q, ConstVector /*u*/,
                                           VectorRef a) const {
  a[0] = -data_.k * q[0] / data_.m;
}

double HarmonicOscillator::gap(std::size_t /*contact*/, double /*t*/, ConstVector /*q*/) const {
  throw std::out_of_range("harmonic oscillator: it has no contact");
}

void HarmonicOscillator::contact_rows(std::size_t /*contact*/, double /*t*/, ConstVector /*q*/,
                                      ConstVector /*u*/, ContactRows& /*rows*/) const {
  throw std::out_of_range("harmonic oscillator: it has no contact");
}

double HarmonicOscillator::kinetic_energy(ConstVector /*q*/, ConstVector u) const {
  return data_.m * u[0] * u[0] / 2;
}

double HarmonicOscillator::potential_energy(ConstVector q) const { return data_.k * q[0] * q[0] / 2; }

}  // namespace contensou
