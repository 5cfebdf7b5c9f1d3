#include "contensou/law/hertz.hpp"

#include <cmath>
#include <numbers>

#include "contensou/law/coefficients.hpp"
#include "contensou/law/polynomial.hpp"
#include "contensou/law/slip_ratio.hpp"

namespace contensou {
namespace {

namespace c = coefficients;

constexpr auto outer_far = interleave(c::hertz_outer_force, c::hertz_outer_torque);
constexpr auto near_seam = interleave(c::hertz_near_force, c::hertz_near_torque);

constexpr double pi_3_128 = 3 * std::numbers::pi / 128;

/// Outside u = 1 the law is analytic in √y with y = (u − 1)/(u + 1), and a polynomial in it up to u = 4/3;
/// further out it is a power series in 1/u².
constexpr double seam = 0.75;

/// The inner polynomials in mc = 1 − u², all of whose terms have
/// one sign for u <= 1: (3.17), (3.18) without cancellation.
double force_over_u(double mc) { return pi_3_128 * (12 + 4 * mc); }
double torque(double mc) { return pi_3_128 * (3 + mc * (2 + 3 * mc)); }
double second(double mc) { return pi_3_128 * (4 + 12 * mc); }

}  // namespace

Extent HertzLaw::extent() const { return {1.0, 8 * pi_3_128}; }

Friction HertzLaw::at(double v, double s) const {
  if (v <= s) {
    if (!(v >= 0 && s > 0 && (v < s || std::isfinite(s)))) require_slip(v, s);
    if (std::isinf(s)) return {0, 8 * pi_3_128};
    const double u = v / s;
    const double mc = (s - v) / s * (1 + u);
    return {force_over_u(mc) * u, torque(mc)};
  }
  if (!(v > s && s >= 0)) require_slip(v, s);
  const double w = s / v;
  if (w > seam) {
    const Lanes form = evaluate(near_seam, std::sqrt(seam_distance(v, s)));
    return {form[0], form[1]};
  }
  const Lanes form = evaluate(outer_far, w * w);
  return {form[0], form[1] * w};
}

Curvature HertzLaw::curvature(double v, double s) const {
  return curvature_from(
      v, s, [](SlipRatio u) { return second(u.gap * (1 + u.x)); },
      [](SlipRatio w) {
        if (w.x <= seam) return evaluate(c::hertz_outer_second, w.x * w.x);
        return evaluate(c::hertz_near_second, std::sqrt(w.gap / (1 + w.x)));
      });
}

}  // namespace contensou
