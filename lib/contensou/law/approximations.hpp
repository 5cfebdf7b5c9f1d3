#pragma once

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// What simulators ship: the ellipsoid with the semi-axes of the friction ball,
/// Φ = μλ_N √(ξ_max² v² + η_max² s²).
class EllipsoidLaw {
 public:
  /// Semi-axes in (0, ∞); throws std::invalid_argument otherwise.
  explicit EllipsoidLaw(Extent semi_axes);
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return axes_; }

 private:
  Extent axes_;
};

/// Sliding and drilling friction that know nothing of each other: disk × interval, Φ = μλ_N (ξ_max v + η_max s).
/// Where one of v, s is zero its friction is a set (a disk, an interval); `at` then returns the element of least norm.
class DecoupledLaw {
 public:
  explicit DecoupledLaw(Extent semi_axes);
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return axes_; }

 private:
  Extent axes_;
};

/// Padé approximations in the manner of Zhuravlev and Kireenkov. They meet the law's value and slope at u = 0 and
/// u = ∞; they are no gradients of a potential.
/// First order:  ξ = u/(u + a),                      η = η_max/(1 + b u).
/// Second order: ξ = (u² + a u)/(u² + a u + a²),     η = η_max (1 + b u)/(1 + b u + c u²).
/// with 1/a = f''(0) = dξ/du at 0, and b, c from η = η_max − f''(0) u²/2 + ... and η → η_tail/u.
class PadeLaw {
 public:
  /// `slope` = f''(0), `tail` = lim u η for u → ∞ (1/(2(2+n)) for σ ∝ (1−ρ²/R²)ⁿ); order 1 or 2.
  /// Throws std::invalid_argument for anything else.
  PadeLaw(int order, double eta_max, double slope, double tail);
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

/// tanh regularisation: ξ = ξ_max tanh(v/ε), η = η_max tanh(s/ε), with a velocity scale ε [m/s]. Smooth, single-valued
/// everywhere (zero at rest: nothing ever sticks), blind to the coupling.
class TanhLaw {
 public:
  /// ε > 0; throws std::invalid_argument otherwise.
  TanhLaw(Extent semi_axes, double epsilon);
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return axes_; }
  /// Φ/(μλ_N) = ε (ξ_max log cosh(v/ε) + η_max log cosh(s/ε)) [m/s].
  double potential(double v, double s) const;

 private:
  Extent axes_;
  double epsilon_;
};

}  // namespace contensou
