#pragma once

#include "contensou/law/force.hpp"

// The part of force.hpp that depends on the law: a few
// lines each. What does not is compiled once, in force.cpp.
namespace contensou::detail {

template <class L>
concept SmoothAtRest = requires {
  requires L::smooth_at_rest;
};

/// μλ_N = factor 2^exponent: the product of two doubles, which need not be one. The factor is zero or far
/// from both ends of the range; the exponent is zero unless the product itself is not.
struct ScaledLoad {
  double factor;
  int exponent;
};

/// γ_F = 2^exponent (v n, ± s), with exponent = 0 for every γ_F that is far from the ends of the range.
struct ScaledSlip {
  double v;       ///< ‖γ_T‖ 2^−exponent; > 0 where γ_T ≠ 0
  double s;       ///< |γ_τ| 2^−exponent; > 0 where γ_τ ≠ 0
  double n1, n2;  ///< γ_T/‖γ_T‖; (1, 0) where γ_T = 0
  double spin;    ///< sgn γ_τ; 0 where γ_τ = 0
  int exponent;

  bool at_rest() const { return v == 0 && s == 0; }
};

/// Checks μ, λ_N.
ScaledLoad scaled(const Load& load);
/// Checks γ_F. Near the ends of the range the exponent is chosen such that
/// the largest of |γ_T1|, |γ_T2|, |γ_τ| is in [1, 2) 2^exponent; with `free`
/// false it is zero always, as a law with a scale of its own needs it.
ScaledSlip scaled(const SlipVelocity& gamma, bool free);

FrictionForce assemble_force(const ScaledLoad& load, const ScaledSlip& slip, const Friction& friction);
FrictionSet assemble_set(const ScaledLoad& load, const Extent& extent);
/// μλ_N reduced 2^exponent.
double assemble_potential(const ScaledLoad& load, int exponent, double reduced);
Eigen::Matrix3d assemble_hessian(const ScaledLoad& load, const ScaledSlip& slip, const Friction& friction,
                                 const Curvature& curvature, const Extent& extent);
[[noreturn]] void no_derivative_at_rest();

}  // namespace contensou::detail

namespace contensou {

template <FrictionLaw L>
FrictionResponse friction_force(const L& law, const Load& load, const SlipVelocity& gamma) {
  const detail::ScaledLoad scaled_load = detail::scaled(load);
  const detail::ScaledSlip slip = detail::scaled(gamma, !HasOwnScale<L>);
  if constexpr (!detail::SmoothAtRest<L>) {
    if (slip.at_rest()) return detail::assemble_set(scaled_load, law.extent());
  }
  return detail::assemble_force(scaled_load, slip, law.at(slip.v, slip.s));
}

template <FrictionLaw L>
double potential(const L& law, const Load& load, const SlipVelocity& gamma) {
  const detail::ScaledLoad scaled_load = detail::scaled(load);
  const detail::ScaledSlip slip = detail::scaled(gamma, !HasOwnScale<L>);
  if (slip.at_rest()) return 0;
  return detail::assemble_potential(scaled_load, slip.exponent, potential(law, slip.v, slip.s));
}

template <FrictionLaw L>
Eigen::Matrix3d hessian(const L& law, const Load& load, const SlipVelocity& gamma) {
  const detail::ScaledLoad scaled_load = detail::scaled(load);
  const detail::ScaledSlip slip = detail::scaled(gamma, !HasOwnScale<L>);
  if constexpr (!detail::SmoothAtRest<L>) {
    if (slip.at_rest()) detail::no_derivative_at_rest();
  }
  return detail::assemble_hessian(scaled_load, slip, law.at(slip.v, slip.s), law.curvature(slip.v, slip.s),
                                  law.extent());
}

}  // namespace contensou
