#include "patch_cases.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <variant>

#include "contensou/law/force.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"

namespace verify::siconos {
namespace {

using contensou::FrictionForce;

/// W = Hᵀ M⁻¹ H [1/kg] of a body of 1 kg with moments of inertia 0.20, 0.30, 0.25 kg m², contact point at
/// (0.3, −0.2, −0.5) m from the centre of mass, normal e_z, contact radius 0.4 m. Its eigenvalues are from 1
/// to 26.
Eigen::Matrix4d body() {
  const Eigen::Vector3d arm(0.3, -0.2, -0.5);
  constexpr double radius = 0.4;
  Eigen::Matrix<double, 6, 4> directions = Eigen::Matrix<double, 6, 4>::Zero();
  const Eigen::Vector3d axes[] = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(),
                                  Eigen::Vector3d::UnitY()};
  for (Eigen::Index k = 0; k < 3; ++k) {
    directions.col(k).head<3>() = axes[k];
    directions.col(k).tail<3>() = arm.cross(axes[k]);
  }
  directions(5, 3) = 1 / radius;
  Eigen::Matrix<double, 6, 1> mobility;
  mobility << 1, 1, 1, 1 / 0.20, 1 / 0.30, 1 / 0.25;
  return directions.transpose() * mobility.asDiagonal() * directions;
}

FrictionForce exact_force(Pressure pressure, const contensou::Load& load, const Eigen::Vector3d& gamma) {
  return std::get<FrictionForce>(pressure == Pressure::uniform
                                     ? friction_force(contensou::UniformLaw{}, load, gamma)
                                     : friction_force(contensou::HertzLaw{}, load, gamma));
}

/// γ_F [m/s] with the slip ratio of the motion.
Eigen::Vector3d slip(const std::string& motion, double angle) {
  if (motion == "sliding") return {std::cos(angle), std::sin(angle), 0.5};
  if (motion == "spinning") return {0, 0, angle < 3 ? 1.0 : -1.0};
  if (motion == "turning" || motion == "sticking") return {0.5 * std::cos(angle), 0.5 * std::sin(angle), 1};
  throw std::logic_error("no such motion: " + motion);
}

}  // namespace

std::vector<PatchCase> patch_cases(const std::string& motion, Pressure pressure) {
  constexpr contensou::Load load{.mu = 0.5, .lambda_n = 1};
  std::vector<PatchCase> cases;
  for (const double angle : {0.4, 2.1, 5.3}) {
    Eigen::Vector3d gamma = slip(motion, angle);
    FrictionForce friction = exact_force(pressure, load, gamma);
    if (motion == "sticking") {
      friction *= 0.9;
      gamma.setZero();
    }
    PatchCase made{motion, pressure, {body(), {}, load.mu}, {}, {}};
    made.force << load.lambda_n, friction;
    made.velocity << 0, gamma;
    made.contact.b = made.velocity - made.contact.w * made.force;
    cases.push_back(made);
  }
  return cases;
}

}  // namespace verify::siconos
