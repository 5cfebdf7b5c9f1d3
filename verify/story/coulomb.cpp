#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "checks.hpp"
#include "contensou/output/table.hpp"

namespace verify::story {
namespace {

constexpr double duration = 30;  // [s]

/// Rates of the two rolling modes of (5.37) [rad/s], the fast one first.
std::array<double, 2> rolling_rates(const contensou::TippeTopData& d, double spin) {
  const double h = d.r1 - d.a1;
  const double a = d.i1 + d.m * h * h, b = (d.i3 + d.m * h * d.r1) * spin, c = d.a1 * d.m * d.g;
  const double root = std::sqrt(b * b / (4 * a * a) + c / a);
  return {b / (2 * a) + root, b / (2 * a) - root};
}

/// Turns of the axis about the vertical [rad/s], least squares would be the same to 1/(number of samples).
double precession(const Curve& c) {
  double turned = 0;
  for (std::size_t k = 1; k < c.axis.size(); ++k) {
    const auto& p = c.axis[k - 1];
    const auto& q = c.axis[k];
    turned += std::atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
  }
  return turned / (c.t.back() - c.t.front());
}

/// Maxima of θ in a second, times 2π.
double nutation(const Curve& c) {
  std::size_t first = 0, last = 0, count = 0;
  for (std::size_t k = 1; k + 1 < c.theta.size(); ++k) {
    if (!(c.theta[k] > c.theta[k - 1] && c.theta[k] >= c.theta[k + 1])) continue;
    if (count++ == 0) first = k;
    last = k;
  }
  if (count < 2) return never;
  return 2 * 3.14159265358979323846 * static_cast<double>(count - 1) / (c.t[last] - c.t[first]);
}

}  // namespace

void take_coulomb_limit(const std::filesystem::path& folder, Record& record) {
  contensou::Table table{{"The tippe-top of LG03 5.4 with Coulomb friction (R = 0) and small R, 180 rad/s, 30 s; SI units."},
                         {"friction", "radius", "mu", "start", "theta_0", "theta_least", "theta_largest", "theta_end", "first_stick", "tip",
                          "precession", "nutation", "spin_end", "energy_lost"},
                         {}};
  const contensou::AnyFriction disk = contensou::FrictionDisk{};
  for (const bool coulomb : {true, false}) {
    for (const double mu : {0.3, 1.0}) {
      for (const bool rolling : {true, false}) {
        for (const double theta : {1e-3, 1e-2, 0.1, 0.3}) {
          Setting s;
          if (coulomb) s.friction = disk;
          s.radius = 1e-6;
          s.mu = mu;
          s.theta = theta;
          s.rolling = rolling;
          s.duration = duration;
          s.options.tolerance = 1e-10;
          const Curve c = follow(s);
          double stick = never;
          for (const auto& e : c.report.events)
            if (std::isnan(stick) && e.kind == contensou::EventKind::stick) stick = e.t;
          table.add({std::string(coulomb ? "coulomb" : "contensou"), coulomb ? 0 : s.radius, mu, std::string(rolling ? "rolling" : "slipping"), theta,
                     *std::min_element(c.theta.begin(), c.theta.end()),
                     *std::max_element(c.theta.begin(), c.theta.end()), c.theta.back(), stick, located(c).tip, precession(c), nutation(c),
                     c.spin.back(), 1 - c.energy.back() / c.energy[0]});
        }
      }
    }
  }
  contensou::write_table(table, folder / "coulomb_limit.tsv");
  (void)record;
  const auto rates = rolling_rates({}, 180);
  std::printf("rates %g %g\n", rates[0], rates[1]);
}

}  // namespace verify::story
