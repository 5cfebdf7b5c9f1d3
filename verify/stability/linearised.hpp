#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>

#include "slipping_top.hpp"

namespace verify::stability {

using Complex = std::complex<double>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector3c = Eigen::Vector3cd;
using Matrix3c = Eigen::Matrix3cd;

/// d/dt of (ẋ_S, ẏ_S, α, β, α̇, β̇) linearised about spinning upright with the momentary spin, by five-point
/// differences of the nonlinear right-hand side. The spin may be slowing down (`drilling`): its rate at this
/// moment is in α̈, β̈.
Matrix6 jacobian(const Setting& setting, double spin);
/// ω̇ of spinning upright.
double spin_rate(const Setting& setting, double spin);

/// The same for (w, ξ, ξ̇) of LG03 (5.27): the floor has no preferred direction, so the 6 × 6 matrix is one of
/// 3 × 3 complex numbers. `defect`: the largest entry that this leaves out, relative to its row's largest.
struct ComplexForm {
  Matrix3c matrix;
  double defect;
};
ComplexForm complex_form(const Matrix6& jacobian);
Matrix3c linearised(const Setting& setting, double spin);

/// Eigenvalues in descending order of real part, and eigenvectors (w, ξ, ξ̇) with ξ = 1.
struct Modes {
  std::array<Complex, 3> eigenvalue;
  Matrix3c vectors;
};
Modes modes(const Matrix3c& matrix);

/// A mode while the spin changes slowly: (w, ξ, ξ̇) = A(t)(shape) exp ∫λ dt. The amplitude A changes at a rate
/// of the order of ω̇/ω, which like the drilling torque is of the order of R: without it the rate of growth is
/// not even right to first order, and depends on the choice of coordinates.
struct SlowMode {
  Complex eigenvalue;  ///< λ at this spin
  double rate;     ///< of growth of |ξ|: Re λ + d ln|A|/dt [1/s]; its error is of second order in ω̇/ω²
  double nearest;  ///< distance of λ from the next eigenvalue [1/s]
  double outgrown;  ///< by how much the real part of another eigenvalue is larger [1/s]; 0: of none
  Vector3c shape;   ///< to first order in ω̇
};
std::array<SlowMode, 3> slow_modes(const Setting& setting, double spin);

/// The state with this mode, |ξ| = inclination.
Eigen::VectorXd state(const Setting& setting, double spin, const SlowMode& mode, double inclination);

}  // namespace verify::stability
