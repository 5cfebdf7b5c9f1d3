#include <contensou/law/force.hpp>
#include <contensou/law/hertz.hpp>
#include <iostream>

int main() {
  const contensou::HertzLaw law;                            // pressure between two balls, LG03 (3.14)
  const contensou::Load load{.mu = 0.3, .lambda_n = 10.0};  // friction coefficient, normal force [N]
  const contensou::SlipVelocity gamma(0.2, 0.0, 0.1);       // gamma_T1, gamma_T2, gamma_tau = omega R [m/s]

  const auto friction = friction_force(law, load, gamma);  // a force, or at rest the whole friction ball
  if (const auto* force = std::get_if<contensou::FrictionForce>(&friction)) {
    std::cout << "lambda_T1 = " << force->x() << " N, tau_N = " << force->z() << " N times R\n";
  }
}
