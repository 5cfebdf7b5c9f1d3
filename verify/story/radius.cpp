#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "laws.hpp"

namespace verify::story {
namespace {

constexpr std::array radii = {1e-5,   1.5e-5, 2e-5, 3e-5,   4e-5, 5e-5, 7e-5, 1e-4, 1.25e-4, 1.5e-4, 1.75e-4, 2e-4,
                              2.5e-4, 3e-4,   4e-4, 5e-4, 6e-4, 7e-4,   8e-4, 1e-3, 1.25e-3, 1.5e-3, 2e-3};
constexpr double longest = 30;  // [s]

double first_above(const Curve& c, double level) {
  for (std::size_t k = 1; k < c.t.size(); ++k) {
    if (c.theta[k] >= level)
      return c.t[k - 1] +
             (level - c.theta[k - 1]) / (c.theta[k] - c.theta[k - 1]) * (c.t[k] - c.t[k - 1]);
  }
  return never;
}

struct Inversion {
  double half;  ///< θ = π/2
  double tip;   ///< the stick touches
};
Inversion inversion(const contensou::AnyFriction& friction, double radius, double theta) {
  Setting s;
  s.friction = friction;
  s.radius = radius;
  s.theta = theta;
  s.duration = longest;
  s.options.tolerance = 1e-10;
  const Curve c = follow(s);
  return {first_above(c, std::numbers::pi / 2), located(c).tip};
}

}  // namespace

void vary_radius(const std::filesystem::path& folder, Record& record) {
  contensou::Table table{{"Inversion of the tippe-top of LG03 5.4 over the contact radius [m]; times in s, nan: not "
                          "within 30 s.",
                          "half: theta first is pi/2; tip: the stick touches. Start at theta_0, 180 rad/s, at rest but for "
                          "the spin.",
                          "pressure: hertz, uniform; no_drilling: Hertz with the drilling torque taken away, the coupling of "
                          "the sliding friction to the spin left."},
                         {"pressure", "theta_0", "radius", "half", "tip"},
                         {}};
  struct Case {
    const char* name;
    contensou::AnyFriction friction;
  };
  const std::array cases{Case{"hertz", hertz()}, Case{"uniform", uniform()}, Case{"no_drilling", without_drilling()}};
  for (const double theta : {0.1, 0.01}) {
    for (const Case& c : cases) {
      for (const double radius : radii) {
        const Inversion i = inversion(c.friction, radius, theta);
        table.add({std::string(c.name), theta, radius, i.half, i.tip});
      }
    }
  }
  contensou::write_table(table, folder / "inversion_over_radius.tsv");
  (void)record;
}

}  // namespace verify::story
