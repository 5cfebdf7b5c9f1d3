#pragma once

#include <array>
#include <functional>
#include <vector>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// A law from a table: for u = v/s <= 1 the potential f(u) = Φ/(μλ_N s), for w = s/v < 1 the potential
/// g(w) = Φ/(μλ_N v), each by piecewise polynomials of degree five that meet the law's potential, friction
/// and second derivative at the nodes. So the table is a law of its own, with a potential that is convex and
/// twice continuously differentiable, and all of friction belongs together exactly; no law is evaluated any
/// more. Nodes are denser towards u = 1, where laws are least smooth: x_i = 1 − (1 − i/cells)².
///
/// Error against the law it was made from, ξ and η: falls with the fourth power of the cells for uniform
/// pressure (for the logarithm at u = 1), with the fifth for Hertz. error_bound() with 16 and 64 cells:
/// uniform 1.1e-7, 4.2e-10; Hertz 6.1e-9, 6.6e-12; n = 5 1.3e-6, 1.5e-9; n = -0.5 6.6e-6, 1.0e-7. Below some
/// 3e-11 the rounding of the differences in the table takes over. Potentials are nearer by another order.
class TabulatedLaw {
 public:
  static constexpr int least_cells = 4;
  static constexpr int most_cells = 256;

  /// `law`: homogeneous of degree one, with a convex potential; `cells` a side, 4 to 256. Throws
  /// std::invalid_argument for another number, and where so few cells leave the potential not convex.
  template <FrictionLaw L>
  TabulatedLaw(const L& law, int cells)
      : TabulatedLaw([&law](double v, double s) { return law.at(v, s); },
                     [&law](double v, double s) { return law.curvature(v, s); }, law.extent(), cells) {}

  /// Throw std::domain_error as every law does (friction_law.hpp).
  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return extent_; }

  /// Twice the largest difference to the law in ξ and η, seen between the nodes at construction.
  double error_bound() const { return error_bound_; }
  int cells() const { return static_cast<int>(inner_.size()); }

 private:
  TabulatedLaw(const std::function<Friction(double, double)>& at,
               const std::function<Curvature(double, double)>& curvature, Extent extent, int cells);

  /// Powers of t = (x − left)/width.
  struct Cell {
    double left;
    double inverse_width;
    std::array<double, 6> potential;
  };
  using Side = std::vector<Cell>;
  /// The derivative of the potential on its side, and what Euler leaves: potential − x derivative.
  struct Pair {
    double across;
    double along;
  };
  static Pair at(const Side& side, double x);
  static double second(const Side& side, double x);
  void require_convex(const Side& side) const;

  Extent extent_;
  double error_bound_ = 0;
  Side inner_;
  Side outer_;
};

}  // namespace contensou
