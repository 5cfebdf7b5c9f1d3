#include "contensou/law/uniform.hpp"

#include <boost/math/special_functions/ellint_rd.hpp>
#include <numbers>

#include "contensou/law/power.hpp"
#include "contensou/law/slip_ratio.hpp"

namespace contensou {
namespace {

constexpr double four_over_3pi = 4 / (3 * std::numbers::pi);

struct BD {
  double b, d;
};
BD elliptic_bd(double mc) {
  return {mc * boost::math::ellint_rd(0.0, 1.0, mc) / 3, boost::math::ellint_rd(0.0, mc, 1.0) / 3};
}

}  // namespace

Friction UniformLaw::at(double v, double s) const {
  require_slip(v, s);
  if (v == s) return {8 * four_over_3pi / 4, four_over_3pi * 2 / 3};
  if (v < s) {
    const double u = v / s;
    const double mc = ((s - v) / s) * (1 + u);
    const auto [b, d] = elliptic_bd(mc);
    return {four_over_3pi * u * (2 * b + mc * d),
            four_over_3pi / 3 * ((3 - u * u) * b + mc * (3 - 2 * u * u) * d)};
  }
  const double w = s / v;
  const double mc = ((v - s) / v) * (1 + w);
  const auto [b, d] = elliptic_bd(mc);
  const double c = w * w > 1e-8 ? (d - b) / (w * w) : std::numbers::pi / 16;
  return {four_over_3pi * (2 * b + mc * d), four_over_3pi / 3 * w * (2 * b + mc * c)};
}

Curvature UniformLaw::curvature(double v, double s) const {
  static const PowerLaw law(0.0);
  return law.curvature(v, s);
}

}  // namespace contensou
