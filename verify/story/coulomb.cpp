#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "checks.hpp"
#include "contensou/output/table.hpp"

namespace verify::story {
namespace {

using contensou::EventKind;

constexpr double duration = 30;  // [s]
constexpr double spin = 180;     // [rad/s]

/// Rates of the two rolling modes of LG03 (5.37) [rad/s], the fast one first.
std::array<double, 2> rolling_rates(const contensou::TippeTopData& d) {
  const double h = d.r1 - d.a1;
  const double a = d.i1 + d.m * h * h, b = (d.i3 + d.m * h * d.r1) * spin, c = d.a1 * d.m * d.g;
  const double root = std::sqrt(b * b / (4 * a * a) + c / a);
  return {b / (2 * a) + root, b / (2 * a) - root};
}

/// Turns of the axis about the vertical [rad/s], on average.
double precession(const Curve& c) {
  double turned = 0;
  for (std::size_t k = 1; k < c.axis.size(); ++k) {
    const auto& p = c.axis[k - 1];
    const auto& q = c.axis[k];
    turned += std::atan2(p[0] * q[1] - p[1] * q[0], p[0] * q[0] + p[1] * q[1]);
  }
  return turned / (c.t.back() - c.t.front());
}

double largest_theta(const Curve& c) { return *std::max_element(c.theta.begin(), c.theta.end()); }

Setting start(double theta, bool rolling) {
  Setting s;
  s.friction = contensou::FrictionDisk{};
  s.theta = theta;
  s.rolling = rolling;
  s.duration = duration;
  s.options.tolerance = 1e-10;
  return s;
}

/// Starts near the trivial position that slip in some direction, how fast, in units of r_1 ψ̇_0 θ_0.
void slipping_starts(Limit& limit) {
  const contensou::TippeTopData data;
  for (const double theta : {1e-4, 1e-3, 1e-2}) {
    for (const double speed : {1.0, 3.0, 10.0, 30.0}) {
      for (int direction = 0; direction < 8; ++direction) {
        const double angle = direction * std::numbers::pi / 4;
        Setting s = start(theta, true);
        s.slide = speed * data.r1 * spin * theta * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        s.duration = 5;  // it rolls by then, and rolling goes on as it is
        const double size = theta * std::max(1.0, speed);
        limit.largest_slipping = std::max(limit.largest_slipping, largest_theta(follow(s)) / size);
        ++limit.slipping;
      }
    }
  }
}

}  // namespace

Limit take_coulomb_limit(const std::filesystem::path& folder, Record& record) {
  contensou::Table table{
      {"The tippe-top of LG03 5.4 with Coulomb friction (radius 0) and with a radius of a micrometre "
       "(Hertz), mu = 0.3, 180 rad/s, 30 s; SI units.",
       "start: rolling (gamma_T = 0) or slipping (v_S = 0, as in 5.4). first_stick: of a slipping start. "
       "precession: of the axis "
       "about the vertical, on average; nutation: maxima of theta. By (5.37) they are -0.54956 and 193.648 "
       "rad/s at small theta."},
      {"radius", "start", "theta_0", "theta_least", "theta_largest", "theta_end", "first_stick",
       "stick_touches", "precession", "nutation", "spin_end", "energy_lost"},
      {}};
  Limit limit;
  const auto [fast, slow] = rolling_rates({});
  limit.precession_537 = slow;
  limit.nutation_537 = fast - slow;  // θ beats with the difference
  for (const bool coulomb : {true, false}) {
    for (const bool rolling : {true, false}) {
      for (const double theta : {1e-3, 1e-2, 0.1, 0.3}) {
        Setting s = start(theta, rolling);
        if (!coulomb) {
          s.friction = hertz();
          s.radius = 1e-6;
          s.options.tolerance = 1e-8;
        }
        const Curve c = follow(s);
        const double turning = precession(c), beat = nutation(c, 0, duration);
        table.add({coulomb ? 0 : s.radius, std::string(rolling ? "rolling" : "slipping"), theta,
                   *std::min_element(c.theta.begin(), c.theta.end()), largest_theta(c), c.theta.back(),
                   first(c, EventKind::stick, 0), first(c, EventKind::close, 1), turning, beat, c.spin.back(),
                   1 - c.energy.back() / c.energy[0]});
        if (!coulomb) continue;
        if (!rolling) {
          if (theta == 0.1) limit.start_54 = largest_theta(c);
          continue;
        }
        limit.largest_rolling = std::max(limit.largest_rolling, largest_theta(c) / theta);
        if (theta != 1e-3) continue;
        limit.precession = turning;
        limit.nutation = beat;
      }
    }
  }
  contensou::write_table(table, folder / "coulomb_limit.tsv");
  slipping_starts(limit);

  record.add(Claim{
      "story.coulomb.rolling", "LG03 5.5, Coulomb friction",
      "from a rolling start, theta_0 = 1e-3 ... 0.3, the top does not invert: largest theta/theta_0 in 30 s",
      1, limit.largest_rolling, limit.largest_rolling - 1, 1e-6, true});
  // The axis ends at some phase of a nutation of amplitude |λ_2/λ_1|.
  record.add(Claim{"story.coulomb.precession", "LG03 (5.37)",
                   "and oscillates at the rates of (5.37), theta_0 = 1e-3: the slow one [rad/s]",
                   limit.precession_537, limit.precession, std::abs(limit.precession - limit.precession_537),
                   2 * std::abs(slow / fast) / duration, true});
  // The first and the last maximum are known to a millisecond.
  record.add(Claim{"story.coulomb.nutation", "LG03 (5.37)", "and the difference of both [rad/s]",
                   limit.nutation_537, limit.nutation, std::abs(limit.nutation - limit.nutation_537),
                   limit.nutation_537 * 2e-3 / duration, true});
  record.add(Claim{
      "story.coulomb.start", "LG03 5.5, Coulomb friction",
      "from the slipping start of 5.4 it does not invert either: largest theta in 30 s, below pi/2 [rad]", 0,
      limit.start_54, limit.start_54, std::numbers::pi / 2, true});
  // Slip ends after v/(μg): a few turns of the nutation, each of which adds no more than the slip has.
  record.add(Claim{
      "story.coulomb.slipping", "LG03 5.5, Lyapunov stability",
      std::to_string(limit.slipping) +
          " slipping starts at theta_0 = 1e-4 ... 1e-2, v = 1 ... 30 r_1 psi_dot_0 theta_0: none diverges; "
          "largest theta over the larger of theta_0 and v/(r_1 psi_dot_0)",
      1, limit.largest_slipping, limit.largest_slipping, 10, true});
  return limit;
}

}  // namespace verify::story
