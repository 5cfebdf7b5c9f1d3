#pragma once

#include <vector>

#include "patch.hpp"

namespace verify::answers {

/// A patch that is kept turning (s = |ω|R) and pushed along the floor by a constant force:
///     v̇ = push − a ξ(v/s),   push = F/m, a = μg.
/// With push < a it comes, from any speed, to v∞ = s u∞, ξ(u∞) = F/(μmg): for small forces F = μmg ξ'(0) v/s,
/// a viscous law, where a patch at rest would not move at all. Near it v − v∞ decays with a ξ'(u∞)/s.
class Pushed {
 public:
  Pushed(const Patch& patch, double a, double s) : patch_(patch.n()), a_(a), s_(s) {}

  /// v∞ [m/s]; 0 <= push < a.
  double terminal_speed(double push) const;
  /// Of the approach, [1/s], by a difference.
  double rate(double push) const;
  /// v from v_0 [m/s], at ascending times.
  std::vector<double> speeds(double push, double from, const std::vector<double>& times) const;
  double speed(double push, double from, double t) const { return speeds(push, from, {t}).front(); }

 private:
  Patch patch_;
  double a_, s_;
};

}  // namespace verify::answers
