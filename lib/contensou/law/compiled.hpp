#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "contensou/law/friction_law.hpp"
#include "contensou/law/slip_ratio.hpp"

namespace contensou {

/// A law as piecewise polynomials in x = min(v, s)/max(v, s) below ½ and in 1 − x above, refined until the
/// tolerance is met. Relative accuracy as `error_bound` says; evaluation takes a look-up and two polynomials
/// of degree 15.
class CompiledLaw {
 public:
  using Form = std::function<BoundedForm(SlipRatio)>;

  /// `inner` and `outer` give the law for v <= s and for v > s, `extent` its largest ξ and η, which `at`
  /// never exceeds. `tolerance`: the relative error aimed at in ξ and η, 4e-16 to 1; second derivatives may
  /// be ten times worse. `breaks`: values of u = v/s > 0 where the law is known to be less smooth (u = 1 is
  /// always one). Throws std::invalid_argument for a tolerance out of range, std::runtime_error where the law
  /// is noise at it or not finite.
  CompiledLaw(const Form& inner, const Form& outer, Extent extent, double tolerance,
              const std::vector<double>& breaks = {});

  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return extent_; }

  /// Bound on the relative difference to the law it was made from, in ξ and η: twice the largest seen on
  /// points between the nodes; more than the tolerance only if the law jumps at some u that is not a break.
  double error_bound() const { return error_bound_; }
  /// The number of polynomial pieces, for the record.
  std::size_t pieces() const;

 private:
  static constexpr int terms = 16;
  /// Polynomials in t = (position − center)/half_width, lowest power first, for force, torque and second.
  struct Piece {
    double center;
    double inverse_half_width;
    std::array<std::array<double, terms>, 3> coefficients;
  };
  /// Pieces that cover positions 0 to ½, with their left ends for look-up.
  struct Half {
    std::vector<double> left;
    std::vector<Piece> pieces;
  };
  /// Position is x in the far half (x <= ½), which resolves laws that are narrow in u, and the gap 1 − x in
  /// the near half, which resolves the seam u = 1.
  struct Side {
    Half far;
    Half near;
    double second_at_seam;  ///< f''(1) itself: for n < −1/2 it moves by percents between u = 1 and the next
                            ///< double
    std::pair<const Piece&, double> find(SlipRatio ratio) const;  ///< the piece and its t
    BoundedForm at(SlipRatio ratio) const;  ///< force and torque only; second is left zero
    double second(SlipRatio ratio) const;
  };

  Half compile(const std::function<BoundedForm(double)>& form, std::vector<double> breaks, double tolerance);
  Side compile_side(const Form& form, const std::vector<double>& breaks, double tolerance);

  Extent extent_;
  double error_bound_ = 0;
  Side inner_;
  Side outer_;
};

}  // namespace contensou
