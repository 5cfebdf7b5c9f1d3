#pragma once

#include <algorithm>
#include <cmath>

#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/friction_disk.hpp"
#include "contensou/contact/slip_bracket.hpp"
#include "contensou/contact/slip_newton.hpp"

namespace contensou::detail {

/// Coulomb's disk: one equation. `guess`: a velocity γ_F ≠ 0 to start from.
inline SlipEnd<2> search_slip(const FrictionDisk&, const ReducedContact<2>& c, const Secular<2>& secular,
                              const Eigen::Vector2d& guess) {
  const double a = (c.a(0, 0) + c.a(1, 1)) / 2;
  const double sigma = guess.norm() / (c.mu * c.n0);
  const auto root = secular.solve({1, 0}, std::max(sigma - a, sigma / 16));
  SlipEnd<2> end{};
  end.iterations = root.iterations;
  if (!root.found) return end;
  if (root.clipped) {
    end_stick(c, root.point.at, end);
  } else {
    const Eigen::Vector2d direction = root.point.at.p.normalized();
    end_slip<2>(c, direction, direction, end);
  }
  return end;
}

/// Coulomb–Contensou's ball: two equations, by Newton's method, and where that fails one in the other.
template <class Law>
SlipEnd<3> search_slip(const FrictionBall<SmoothPlate<Law>>& ball, const ReducedContact<3>& c,
                       const Secular<3>& secular, const Eigen::Vector3d& guess) {
  const SmoothPlate<Law>& plate = ball.plate();
  const double v = guess.head<2>().norm();
  const double s = std::abs(guess[2]);
  const SlipPlace place = slip_place(v, s);
  const BorderPoint start = stored_border(plate, place);
  const Ellipsoid& e = start.ellipsoid;
  const double sigma = std::sqrt(v * v / e.a + s * s / e.c) / (c.mu * c.n0);
  SlipEnd<3> end{};
  if (!newton_slip(plate, c, secular, place, start, sigma, end)) {
    bracket_slip(plate.law(), c, secular, place, sigma, end);
  }
  return end;
}

}  // namespace contensou::detail
