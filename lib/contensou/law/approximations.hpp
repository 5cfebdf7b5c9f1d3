#pragma once

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// What simulators ship: the ellipsoid with the semi-axes of the friction ball,
/// Φ = μλ_N √(ξ_max² v² + η_max² s²). Evaluated to a few ulp for every pair of doubles.
class EllipsoidLaw {
 public:
  /// Semi-axes in (0, ∞), the square of each over the other still finite; throws std::invalid_argument
  /// otherwise.
  explicit EllipsoidLaw(Extent semi_axes);
  /// Throw std::domain_error as every law does (friction_law.hpp).
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return axes_; }

 private:
  Extent axes_;
};

/// Sliding and drilling friction that know nothing of each other: disk × interval, Φ = μλ_N (ξ_max v + η_max
/// s). Where one of v, s is zero its friction is a set (a disk, an interval); `at` then returns the element
/// of least norm, zero, and `curvature` an infinite vv (v = 0) or ss (s = 0), for Φ has a kink there.
/// Everywhere else the curvature is zero.
class DecoupledLaw {
 public:
  /// Semi-axes in (0, ∞); throws std::invalid_argument otherwise.
  explicit DecoupledLaw(Extent semi_axes);
  /// Throw std::domain_error as every law does (friction_law.hpp).
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return axes_; }

 private:
  Extent axes_;
};

/// Padé approximations in the manner of Zhuravlev and Kireenkov. They meet the law's value and slope of ξ at
/// u = 0 and its values at u = ∞.
///   First order:  ξ = u/(u + a),                      η = η_max/(1 + b u).
///   Second order: ξ = (u² + a u)/(u² + a u + a²),     η = η_max (1 + b u)/(1 + b u + c u²).
/// 1/a = f''(0) = dξ/du at 0. First order: b from u η → tail for u → ∞; its η has a slope at u = 0 where the
/// law has none. Second order: c from η = η_max − f''(0) u²/2 + ... and b from u η → tail. Evaluated to a
/// few ulp.
///
/// They are no gradients of a potential: ∂ξ/∂s and ∂η/∂v differ. `curvature` returns
/// vv = ∂ξ/∂v and ss = ∂η/∂s as they are and for vs the geometric mean of the two,
/// −√(∂ξ/∂s ∂η/∂v) = −√(vv ss), which keeps the matrix symmetric and positive
/// semi-definite; γ_F is in its null space only as far as the approximation is good.
class PadeLaw {
 public:
  /// `slope` = f''(0), `tail` = lim u η for u → ∞ (1/(2(2+n)) for σ ∝ (1−ρ²/R²)ⁿ), see PowerLimits; all of
  /// eta_max, slope, tail in (0, ∞), eta_max, a, b, c in [1e-70, 1e70]; order 1 or 2. Throws
  /// std::invalid_argument for anything else.
  PadeLaw(int order, double eta_max, double slope, double tail);
  /// Throw std::domain_error as every law does (friction_law.hpp).
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return {1.0, eta_max_}; }

 private:
  int order_;
  double eta_max_;
  double a_;
  double b_;
  double c_;
};

/// tanh regularisation: ξ = ξ_max tanh(v/ε), η = η_max tanh(s/ε), with a
/// velocity scale ε [m/s]. Smooth, single-valued everywhere (zero at rest:
/// nothing ever sticks), blind to the coupling. Evaluated to a few ulp; the
/// curvature, which falls like e^{−2z} with z = v/ε or s/ε, to a few and 2z.
class TanhLaw {
 public:
  /// Semi-axes and ε in (0, ∞); throws std::invalid_argument otherwise.
  TanhLaw(Extent semi_axes, double epsilon);
  /// This law has a value at rest too: at(0, 0) is {0, 0}, and friction_force returns it instead of a set.
  static constexpr bool smooth_at_rest = true;
  /// Throw std::domain_error for negative v, s and NaN.
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return axes_; }
  /// Φ/(μλ_N) = ε (ξ_max log cosh(v/ε) + η_max log cosh(s/ε)) [m/s]. Errors as `at`.
  double potential(double v, double s) const;

 private:
  Extent axes_;
  double epsilon_;
};

}  // namespace contensou
