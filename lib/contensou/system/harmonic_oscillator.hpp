#pragma once

#include "contensou/integrate/mechanical_system.hpp"

namespace contensou {

struct HarmonicOscillatorData {
  double m = 1;  ///< [kg] > 0
  double k = 1;  ///< [N/m] >= 0
};

/// mẍ = −kx, without contact: what an integrator does to amplitude and phase when left alone.
class HarmonicOscillator final : public MechanicalSystem {
 public:
  /// Throws std::invalid_argument with one line for data that make no sense.
  explicit HarmonicOscillator(const HarmonicOscillatorData& data);

  const HarmonicOscillatorData& data() const { return data_; }
  double frequency() const;  ///< √(k/m) [rad/s]

  Eigen::Index coordinates() const override { return 1; }
  Eigen::Index velocities() const override { return 1; }

  void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const override;
  void force(double t, ConstVector q, ConstVector u, VectorRef h) const override;
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override;
  /// There is no contact: throws std::out_of_range.
  double gap(std::size_t contact, double t, ConstVector q) const override;
  /// There is no contact: throws std::out_of_range.
  void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                    ContactRows& rows) const override;
  double kinetic_energy(ConstVector q, ConstVector u) const override;
  double potential_energy(ConstVector q) const override;

 private:
  HarmonicOscillatorData data_;
};

}  // namespace contensou
