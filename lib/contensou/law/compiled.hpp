#pragma once

#include <array>
#include <functional>
#include <vector>

#include "contensou/law/friction_law.hpp"

namespace contensou {

/// What a compiled law approximates: the bounded forms of a law that depends on u = v/s only.
/// For v <= s (x = v/s): force = ξ/x, torque = η, second = f''.
/// For v > s (x = s/v): force = ξ, torque = η/x, second = u³ f''.
/// All three are positive and bounded away from zero on 0 <= x <= 1, which is what makes a relative bound possible.
struct BoundedForm {
  double force;
  double torque;
  double second;
};

/// A law as piecewise polynomials in x = min(v, s)/max(v, s), refined until the stated bound is met.
class CompiledLaw {
 public:
  /// `inner(u)` and `outer(w)` give the law at v/s = u and s/v = w in [0, 1].
  /// `tolerance`: the relative error aimed at in force and torque, at least 4e-16.
  /// `breaks`: values of u = v/s > 0 where the law is known to be less smooth (u = 1 is always one).
  CompiledLaw(const std::function<BoundedForm(double)>& inner, const std::function<BoundedForm(double)>& outer,
              Extent extent, double tolerance, const std::vector<double>& breaks = {});

  Friction at(double v, double s) const;
  Curvature curvature(double v, double s) const;
  Extent extent() const { return extent_; }

  /// The largest relative difference to the compiled law in ξ and η that was seen on points between the nodes.
  double error_bound() const { return error_bound_; }
  /// The number of polynomial pieces, for the record.
  std::size_t pieces() const { return inner_.size() + outer_.size(); }

  struct Piece;

 private:
  std::vector<Piece> inner_;
  std::vector<Piece> outer_;
  Extent extent_;
  double error_bound_ = 0;
};

}  // namespace contensou
