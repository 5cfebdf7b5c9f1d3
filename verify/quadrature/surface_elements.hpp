#pragma once

#include <Eigen/Core>

#include "adaptive.hpp"
#include "pressure.hpp"
#include "reduced_integrals.hpp"

namespace verify {

/// A contact as it stands, in SI units and with signs.
struct Contact {
  double mu;
  double lambda_n;  ///< [N]
  double radius;    ///< [m]
  double gamma_t1;  ///< [m/s]
  double gamma_t2;  ///< [m/s]
  double omega;     ///< [rad/s]
};

/// Coulomb's law on every element, without symmetry and without reduced variables: an element at x carries
/// the friction −μσ w/|w| dA with w = γ_T + ω e_3 × x. Returned is (λ_T1, λ_T2, τ_N/R) [N], the sum of forces
/// and of moments about the centre, LG03 (2.1), (2.17).
///
/// Components may cancel, so the tolerances are absolute: those of reduced_integrals.hpp times μλ_N.
Eigen::Vector3d friction_of_elements(const Contact& contact, const Pressure& pressure);

/// The second derivatives of Φ in γ_F [N s/m]: an element contributes μσ Gᵀ (I − w wᵀ/|w|²)/|w| G dA, where w
/// = G γ_F. Tolerances are absolute, in units of μλ_N over the larger of ‖γ_T‖ and |γ_τ|.
Eigen::Matrix3d hessian_of_elements(const Contact& contact, const Pressure& pressure);

/// The dissipated power Φ = ∬ μσ |w| dA [W] of the same contact.
double power_of_elements(const Contact& contact, const Pressure& pressure);

}  // namespace verify
