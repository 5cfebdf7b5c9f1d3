#pragma once

#include <algorithm>
#include <cmath>

#include "contensou/contact/slip_end.hpp"
#include "contensou/contact/slip_equations.hpp"

namespace contensou::detail {

/// The equations of slip one in the other, each bracketed: where on the border, and for each such place the
/// equation in σ. Slow and safe. Along the border from the pole to the equator, x_F lies first outward, then
/// inward of it.
template <class Law>
void bracket_slip(const Law& law, const ReducedContact<3>& c, const Secular<3>& secular, SlipPlace place,
                  double sigma, SlipEnd<3>& end) {
  constexpr int most_iterations = 100;
  constexpr double small_step = 0x1p-28;
  SlipPlace low{true, 0};
  SlipPlace high{false, 0};
  double step_before = 2;
  for (int i = 1; i <= most_iterations; ++i) {
    const BorderPoint border = exact_border(law, place);
    const auto root = secular.solve(border.ellipsoid, sigma);
    end.iterations += root.iterations;
    if (!root.found) return;

    const auto q = slip_equations(secular, border, root.sigma, root.point);
    // Along the border, σ following.
    const double d_sigma = root.clipped ? 0 : -q.ratio_by_x / q.ratio_by_sigma;
    const double fall = q.value_by_x + d_sigma * q.value_by_sigma;
    (q.value > 0 ? low : high) = place;
    const double next = place.x - q.value / fall;
    const double step = std::abs(next - place.x);
    const SlipPlace goal = slip_place_from(place.inner, next);
    const bool falls = place.inner ? fall < 0 : fall > 0;
    const bool newton = falls && 2 * step <= step_before && !(goal < low) && !(high < goal);
    if (q.value == 0 || (newton && step <= small_step * place.x)) {
      const double dx = q.value == 0 ? 0 : next - place.x;
      const Eigen::Vector3d p = q.point.at.p + dx * (q.p_by_x + d_sigma * q.p_by_sigma);
      if (root.clipped) return end_stick<3>(c, {p, q.point.at.det}, end);
      return end_slip(law, c, {place.inner, place.x + dx}, p, end);
    }
    step_before = newton ? step : 2;
    sigma = root.sigma;
    if (newton && goal.inner == place.inner && !root.clipped) {
      sigma += d_sigma * (goal.x - place.x);
      if (!(sigma > 0)) sigma = root.sigma;
    }
    place = newton ? goal : between(low, high);
  }
}

}  // namespace contensou::detail
