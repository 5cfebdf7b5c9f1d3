// Scenes of balls for the tests of many bodies.
#pragma once

#include <string>

#include "contensou/granular/nscd.hpp"
#include "contensou/system/body_layout.hpp"

namespace balls {

using namespace contensou;

/// Surface 0 is of all balls, 1 of all planes; one rule for both.
inline BodiesData scene(const AnyFriction& friction, double mu, double restitution, double radius = 1e-3) {
  BodiesData data;
  data.gravity = {0, 0, -9.81};
  data.rules.push_back({"touch", friction, mu, radius, restitution});
  data.rule.resize(2, 2);
  data.rule << 0, 0, 0, BodiesData::no_rule;
  return data;
}

/// A homogeneous ball.
inline BodyData& add_ball(BodiesData& data, double mass, double radius, const Eigen::Vector3d& position) {
  BodyData ball;
  ball.name = "ball" + std::to_string(data.bodies.size());
  ball.rotation = Rotation::free;
  ball.mass = mass;
  ball.inertia.setConstant(0.4 * mass * radius * radius);
  ball.spheres.push_back({ball.name + ".sphere", Eigen::Vector3d::Zero(), radius, 0});
  ball.position = position;
  data.bodies.push_back(ball);
  return data.bodies.back();
}

inline void add_plane(BodiesData& data, const Eigen::Vector3d& normal, double offset) {
  data.planes.push_back({"plane" + std::to_string(data.planes.size()), normal, offset, 1});
}

inline double energy(const BodyLayout& layout, const State& state) {
  return layout.kinetic_energy(state.u) + layout.potential_energy(state.q);
}

}  // namespace balls
