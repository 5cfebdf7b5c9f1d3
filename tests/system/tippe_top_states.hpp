#pragma once

#include <vector>

#include "contensou/system/tippe_top_axis.hpp"
#include "contensou/system/tippe_top_euler.hpp"

namespace system_test {

inline const contensou::AnyFriction hertz{
    contensou::FrictionBall(contensou::SmoothPlate(contensou::HertzLaw{}))};
inline const contensou::AnyFriction point{contensou::FrictionDisk{}};

/// A top with all numbers of order one, prolate, and one that is oblate.
inline const contensou::TippeTopData solid{
    .m = 1.3, .i1 = 0.8, .i3 = 0.7, .g = 2, .a1 = 0.3, .a2 = 1.6, .r1 = 1.5, .r2 = 0.5};
inline const contensou::TippeTopData flat{
    .m = 0.7, .i1 = 0.6, .i3 = 1.1, .g = 2, .a1 = -0.4, .a2 = 0.9, .r1 = 1.1, .r2 = 0.3};

/// Generic states in Euler angles, far from their singularity; θ also outside [0, π].
inline std::vector<contensou::State> euler_states() {
  std::vector<contensou::State> states;
  for (const double theta : {0.7, 1.9, 2.6, -0.8, 3.9}) {
    contensou::State s{0.2, Eigen::VectorXd(6), Eigen::VectorXd(6)};
    s.q << 0.3, -0.2, 1.4, theta, 0.4 + theta, -1.1;
    s.u << 0.5, -0.8, 0.3, 1.3, -0.9, 1.7;
    states.push_back(s);
  }
  return states;
}

/// The same physical state for TippeTopAxis.
inline contensou::State axis_state(const contensou::TippeTopEuler& euler, const contensou::State& e) {
  contensou::State a{e.t, Eigen::VectorXd(6), Eigen::VectorXd(6)};
  a.q << e.q.head<3>(), euler.axis(e.q);
  a.u << e.u.head<3>(), euler.spin(e.q, e.u);
  return a;
}

}  // namespace system_test
