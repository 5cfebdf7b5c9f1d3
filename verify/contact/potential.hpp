#pragma once

#include "contensou/contact/contact_problem.hpp"
#include "contensou/law/friction_law.hpp"

namespace random_contact {

/// Φ/(μλ_N) for ‖γ_T‖ = v and |γ_τ| = s, of the law alone: no ball, no projection. A disk knows no spin.
struct Potential {
  double operator()(const contensou::FrictionDisk&, double v, double) const { return v; }
  double operator()(const contensou::FrictionCylinder& cylinder, double v, double s) const {
    return v + cylinder.eta_max() * s;
  }
  template <class L>
  double operator()(const contensou::FrictionBall<contensou::SmoothPlate<L>>& ball, double v,
                    double s) const {
    return v == 0 && s == 0 ? 0 : potential(ball.plate().law(), v, s);
  }
};

}  // namespace random_contact
