#pragma once

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

/// From which slip ratio u = ‖γ_T‖/|γ_τ| on a contact with drilling friction may be taken for a point
/// contact: what is left out is the friction torque, η(u) μλ_N R, and what is too large the sliding friction,
/// by (1 − ξ(u)) μλ_N. Both fall with u, for every law that is the gradient of a convex potential.
class CoulombLimit {
 public:
  /// Never, for any friction.
  CoulombLimit();
  /// Where 1 − ξ <= fidelity and η <= fidelity; never without drilling friction. fidelity > 0, not checked.
  /// The friction outlives this. Some 70 evaluations of the law.
  CoulombLimit(const AnyFriction& friction, double fidelity);

  /// The least such u to one part in 1e6, from above; infinite for never.
  double slip_ratio() const { return slip_ratio_; }
  /// max(1 − ξ, η) where ‖γ_T‖ = v > 0, |γ_τ| = s >= 0; only where slip_ratio() is finite.
  double error(double v, double s) const { return error_(*friction_, v, s); }
  /// A bound on it where v/s >= slip_ratio(), no more than the fidelity: the error at a u up to a tenth
  /// smaller, at which it was asked for last, so that the law is not evaluated for each small change.
  double bound(double v, double s);

 private:
  const AnyFriction* friction_ = nullptr;
  double (*error_)(const AnyFriction&, double v, double s) = nullptr;
  double slip_ratio_;
  double known_at_ = 0;  ///< u of bound()
  double known_ = 0;
};

}  // namespace contensou
