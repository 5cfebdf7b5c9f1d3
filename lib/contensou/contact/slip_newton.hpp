#pragma once

#include <algorithm>
#include <cmath>

#include "contensou/contact/slip_end.hpp"
#include "contensou/contact/slip_equations.hpp"

namespace contensou::detail {

/// Both equations of slip at once by Newton's method, from `start` at `place` and σ: first on the stored
/// border, then with the law's. Fast and without safeguards: returns false where the steps do not shrink
/// soon.
template <class Law>
bool newton_slip(const SmoothPlate<Law>& plate, const ReducedContact<3>& c, const Secular<3>& secular,
                 SlipPlace place, const BorderPoint& start, double sigma, SlipEnd<3>& end) {
  constexpr int most_iterations = 12;
  // Relative steps: below the first, the next is worth the law; below the second, only rounding is left.
  constexpr double near = 0x1p-12;
  constexpr double small_step = 0x1p-24;
  BorderPoint border = start;
  bool exact = false;
  for (int i = 0; i < most_iterations; ++i) {
    ++end.iterations;
    const auto q = slip_equations(secular, border, sigma, secular.point(border.ellipsoid, sigma));
    const double missing = 1 - q.point.ratio;
    const double inverse = 1 / (q.ratio_by_sigma * q.value_by_x - q.ratio_by_x * q.value_by_sigma);
    const double dx = -(q.value * q.ratio_by_sigma + missing * q.value_by_sigma) * inverse;
    const double d_sigma = (missing * q.value_by_x + q.value * q.ratio_by_x) * inverse;
    if (!(std::isfinite(dx) && std::isfinite(d_sigma))) return false;
    const auto below = [&](double step) {
      return std::abs(dx) <= step * place.x && std::abs(d_sigma) <= step * sigma;
    };
    const double x = place.x + dx;
    if (exact && below(small_step)) {
      end_slip(plate.law(), c, {place.inner, x}, q.point.at.p + dx * q.p_by_x + d_sigma * q.p_by_sigma, end);
      return true;
    }
    exact = below(near);
    place = slip_place_from(place.inner, x > 0 ? x : place.x / 4);
    sigma = std::max(sigma + d_sigma, sigma / 16);
    border = exact ? refined_border(plate, place) : stored_border(plate, place);
  }
  return false;
}

}  // namespace contensou::detail
