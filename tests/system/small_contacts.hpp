#pragma once

#include "differences.hpp"

namespace system_test {

/// A contact `floor` with each kind of friction; R of order one, as all lengths in these tests.
inline contensou::SystemContact smooth_floor() { return {"floor", contensou::NoFriction{}, 0, 0, 0}; }
inline contensou::SystemContact coulomb_floor(double mu = 0.3) {
  return {"floor", contensou::FrictionDisk{}, mu, 0, 0};
}
inline contensou::SystemContact hertz_floor(double mu = 0.3, double radius = 0.4) {
  return {"floor", contensou::FrictionBall(contensou::SmoothPlate(contensou::HertzLaw{})), mu, radius, 0};
}
inline contensou::SystemContact uniform_floor(double mu = 0.3, double radius = 0.4) {
  return {"floor", contensou::FrictionBall(contensou::SmoothPlate(contensou::UniformLaw{})), mu, radius, 0};
}

/// A state of generic numbers between ±1.
inline contensou::State generic_state(const contensou::MechanicalSystem& system) {
  return {0.2, generic(system.coordinates(), 0.1), generic(system.velocities(), 0.4)};
}

}  // namespace system_test
