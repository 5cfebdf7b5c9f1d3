#include "contensou/law/hertz.hpp"

#include <numbers>

#include "contensou/law/power.hpp"

namespace contensou {
Extent HertzLaw::extent() const { return {1.0, 3 * std::numbers::pi / 16}; }
Friction HertzLaw::at(double v, double s) const {
  static const PowerLaw law(0.5);
  return law.at(v, s);
}
Curvature HertzLaw::curvature(double v, double s) const {
  static const PowerLaw law(0.5);
  return law.curvature(v, s);
}
}  // namespace contensou
