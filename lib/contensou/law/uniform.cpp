#include "contensou/law/uniform.hpp"

#include <cmath>

#include "contensou/law/coefficients.hpp"
#include "contensou/law/polynomial.hpp"
#include "contensou/law/slip_ratio.hpp"

namespace contensou {
namespace {

namespace c = coefficients;

constexpr auto inner_far = interleave(c::uniform_force, c::uniform_inner_torque);
constexpr auto outer_far = interleave(c::uniform_force, c::uniform_outer_torque);
constexpr auto near_seam = interleave(c::uniform_near_force, c::uniform_near_torque);
constexpr auto near_seam_log = interleave(c::uniform_near_force_log, c::uniform_near_torque_log);

/// The seam: for u in (3/4, 4/3) the laws are P(y) + y^k ln|y| Q(y) in y = (u − 1)/(u + 1), with the same
/// analytic P and Q on both sides; further away they are power series in u² or 1/u².
constexpr double seam = 0.75;

/// y ln|y|, with its limit 0 at the seam itself.
double y_log_y(double y) { return y == 0 ? 0 : y * std::log(std::abs(y)); }

Friction at_seam(double y) {
  const Lanes value = evaluate(near_seam, y) + y * y_log_y(y) * evaluate(near_seam_log, y);
  return {value[0], value[1]};
}

double second_at_seam(double y) {
  return evaluate(c::uniform_near_second, y) + y_log_y(y) * evaluate(c::uniform_near_second_log, y);
}

}  // namespace

Friction UniformLaw::at(double v, double s) const {
  if (v <= s) {
    if (!(v >= 0 && s > 0 && (v < s || std::isfinite(s)))) require_slip(v, s);
    const double u = std::isinf(s) ? 0 : v / s;
    if (u > seam) return at_seam(seam_distance(v, s));
    const Lanes form = evaluate(inner_far, u * u);
    return {form[0] * u, form[1]};
  }
  if (!(v > s && s >= 0)) require_slip(v, s);
  const double w = s / v;
  if (w > seam) return at_seam(seam_distance(v, s));
  const Lanes form = evaluate(outer_far, w * w);
  return {form[0], form[1] * w};
}

Curvature UniformLaw::curvature(double v, double s) const {
  return curvature_from(
      v, s,
      [](SlipRatio u) {
        return u.x > seam ? second_at_seam(-u.gap / (1 + u.x)) : evaluate(c::uniform_inner_second, u.x * u.x);
      },
      [](SlipRatio w) {
        if (w.x <= seam) return evaluate(c::uniform_outer_second, w.x * w.x);
        return second_at_seam(w.gap / (1 + w.x)) / (w.x * w.x * w.x);
      });
}

}  // namespace contensou
