#include "contensou/integrate/motion_scales.hpp"

#include <algorithm>
#include <cmath>

namespace contensou {

MotionScales motion_scales(const MechanicalSystem& system, const State& state) {
  const Eigen::Index n = system.coordinates();
  const Eigen::Index f = system.velocities();
  MotionScales scales;
  scales.length = system.length_scale();
  scales.coordinate.resize(n);
  system.coordinate_scales(scales.coordinate);

  Eigen::MatrixXd mass(f, f);
  Eigen::VectorXd free(f), rates(n);
  system.mass_matrix(state.q, mass);
  system.free_acceleration(state.t, state.q, Eigen::VectorXd::Zero(f), free);
  system.coordinate_rates(state.q, free, rates);
  const double bend = (rates.array() / scales.coordinate.array()).abs().maxCoeff();
  const bool accelerated = bend > 0 && std::isfinite(bend);
  scales.time = accelerated ? 1 / std::sqrt(bend) : 1;
  const double gained = accelerated ? free.dot(mass * free) / 2 * scales.time * scales.time : 0;
  scales.energy = std::max(system.kinetic_energy(state.q, state.u), gained);
  if (!(scales.energy > 0 && std::isfinite(scales.energy))) scales.energy = 1;
  scales.velocity = (2 * scales.energy / mass.diagonal().array()).sqrt();
  // Of the coordinates that are lengths, the lightest moves fastest; a bound that needs no geometry.
  scales.speed = scales.length / scales.time;
  system.coordinate_rates(state.q, state.u, rates);
  scales.speed =
      std::max(scales.speed, scales.length * (rates.array() / scales.coordinate.array()).abs().maxCoeff());
  return scales;
}

double spin_factor(const SystemContact& contact, double length) {
  return rows(contact.friction) > 3 ? length / contact.radius : 0;
}

}  // namespace contensou
