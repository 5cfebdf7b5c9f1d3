#include "laws.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "contensou/law/power.hpp"

namespace verify::story {
namespace {

using contensou::BoundedForm;
using contensou::CompiledLaw;
using contensou::Friction;
using contensou::FrictionBall;
using contensou::SlipRatio;
using contensou::SmoothPlate;

/// Digits that no time to 1e-5 s needs more of.
constexpr double accuracy = 1e-9;
/// Ratios of speeds below this are as good as it: ξ/u and η u have limits.
constexpr double tiny = 1e-10;
constexpr double square = std::numbers::pi * std::numbers::pi;

template <class Law>
HomogeneousLaw of(const Law& law) {
  return {[law](double v, double s) { return law.at(v, s); },
          [law](double v, double s) {
            const contensou::Curvature c = law.curvature(v, s);
            return s == 1 ? c.vv : c.ss;  // u³f'' = f_ss at v = 1
          }};
}

template <class Law>
contensou::AnyFriction radial_of(const SmoothPlate<Law>& plate) {
  // With the gauge g(v, s) of the plate, (ξ, η) = (v, s)/g, and ∂g/∂s = n_τ/support(n) with the normal n at
  // the border point on the ray. ξ is homogeneous of degree zero: v ∂ξ/∂v = −s ∂ξ/∂s = (v s/g²) ∂g/∂s.
  return compiled({[&plate](double v, double s) {
                     const double gauge = plate.ray(v, s).gauge;
                     return Friction{v / gauge, s / gauge};
                   },
                   [&plate](double v, double s) {
                     const contensou::PlateRay ray = plate.ray(v, s);
                     const auto n = ray.direction;
                     return n.tau / s / (plate.support(n.t, n.tau) * ray.gauge * ray.gauge);
                   }});
}

}  // namespace

contensou::AnyFriction compiled(const HomogeneousLaw& law) {
  const auto inner = [&law](SlipRatio u) {
    const double x = std::max(u.x, tiny);
    const Friction f = law.friction(x, 1);
    return BoundedForm{f.xi / x, f.eta, law.slope(x, 1)};
  };
  const auto outer = [&law](SlipRatio w) {
    const double x = std::max(w.x, tiny);
    const Friction f = law.friction(1, x);
    return BoundedForm{f.xi, f.eta / x, law.slope(1, x)};
  };
  const contensou::Extent extent{law.friction(1, 0).xi, law.friction(0, 1).eta};
  return FrictionBall(SmoothPlate(CompiledLaw(inner, outer, extent, accuracy)));
}

contensou::AnyFriction paraboloid() { return compiled(of(contensou::PowerLaw(1))); }
contensou::AnyFriction ellipsoid() {
  return FrictionBall(SmoothPlate(contensou::EllipsoidLaw(contensou::HertzLaw{}.extent())));
}
contensou::AnyFriction radial_hertz() { return radial_of(SmoothPlate(contensou::HertzLaw{})); }
contensou::AnyFriction radial_uniform() { return radial_of(SmoothPlate(contensou::UniformLaw{})); }
contensou::AnyFriction without_drilling() {
  constexpr double part = 1e-6;
  const contensou::HertzLaw hertz;
  HomogeneousLaw law = of(hertz);
  law.friction = [hertz](double v, double s) {
    const Friction f = hertz.at(v, s);
    return Friction{f.xi, part * f.eta};
  };
  return compiled(law);
}
contensou::AnyFriction misprinted_slope() {
  const contensou::HertzLaw hertz;
  return compiled({[hertz](double v, double s) { return hertz.at(v, square * s); },
                   [hertz](double v, double s) {
                     const contensou::Curvature c = hertz.curvature(v, square * s);
                     return s == 1 ? c.vv : square * square * c.ss;
                   }});
}

}  // namespace verify::story
