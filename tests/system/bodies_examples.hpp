// Bodies that tests of rigid bodies share.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "contensou/system/rigid_bodies.hpp"
#include "small_contacts.hpp"

namespace system_test {

inline contensou::SystemContact named(contensou::SystemContact contact, const std::string& name) {
  contact.name = name;
  return contact;
}

/// The table of rules: surfaces a and b touch by rule k, for the k-th of the pairs (a, b).
inline void set_rules(contensou::BodiesData& data, Eigen::Index surfaces,
                      std::initializer_list<std::pair<int, int>> pairs) {
  data.rule.setConstant(surfaces, surfaces, contensou::BodiesData::no_rule);
  int k = 0;
  for (const auto& [a, b] : pairs) data.rule(a, b) = data.rule(b, a) = k++;
}

/// A homogeneous ball of mass m and radius r, surface `surface`.
inline contensou::BodyData ball(const std::string& name, double m, double r, std::size_t surface) {
  contensou::BodyData body;
  body.name = name;
  body.rotation = contensou::Rotation::free;
  body.mass = m;
  body.inertia.setConstant(2 * m * r * r / 5);
  body.spheres = {{name + ".shell", Eigen::Vector3d::Zero(), r, surface}};
  return body;
}

/// The plane z = 0, surface `surface`.
inline contensou::PlaneData floor_plane(std::size_t surface) {
  return {"floor", Eigen::Vector3d::UnitZ(), 0, surface};
}

/// The same state with all velocities and positions generic; quaternions of unit length.
inline contensou::State generic_state(const contensou::RigidBodies& system) {
  contensou::State s{0.2, generic(system.coordinates(), 0.1), generic(system.velocities(), 0.4)};
  system.restore(s.q);
  return s;
}

}  // namespace system_test
