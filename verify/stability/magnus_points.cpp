#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "simulate.hpp"

namespace verify::stability {
namespace {

constexpr std::array shapes_h = {0.25, 0.5, 0.68, 0.92, 1.2, 1.5, 1.9, 2.4, 2.9, 3.4, 3.9, 4.4};
constexpr std::array shapes_i = {0.125, 0.4, 0.65, 0.9, 1.15, 1.4, 1.65, 1.9};

struct Point {
  Setting setting;
  std::string top;
  std::string region;
};

std::vector<Point> points() {
  std::vector<Point> all;
  for (const double x : shapes_h) {
    for (const double y : shapes_i) {
      if (std::abs(x * y - 1) < 0.08) continue;  // so near the hyperbola the critical spin has no bounds
      all.push_back({top_of_shape(x, y), "of this shape",
                     x < 1 ? (x * y > 1 ? "III" : "IV") : (x * y < 1 ? "I" : "II")});
    }
  }
  all.push_back({paper_top(0), "LG03 5.4, trivial", "IV"});
  all.push_back({paper_top(1), "LG03 5.4, inverted", "II"});
  return all;
}

/// Of a shape so that friction damps it well: ε of about mω, R at most 2 mm.
double radius_for(const Setting& s, double spin) {
  return std::min(2e-3, s.mu * s.top.g * 1.2 / (spin * spin));
}

}  // namespace

void check_points(const std::filesystem::path& folder, Record& record) {
  contensou::Table table{
      {"Points of Magnus's diagram, LG03 Fig. 11, checked by simulation of the nonlinear top from a small "
       "tilt; SI "
       "units.",
       "spin_over: spin over the critical one, (5.35), in Regions II and IV, else over sqrt(|a|mg/I_1). "
       "says: what "
       "the diagram says. theta_ratio: theta after 8 e-foldings of the slowest eigenvalue over theta at the "
       "start, "
       "drilling torque left out as in (5.22); grows if > 10, decays if < 1/10.",
       "rate_drilling: growth of ln(theta) [1/s] with the drilling torque while the spin loses 1 % at most, "
       "in the "
       "mode that then grows fastest; power: theta then goes like spin^-power; does_drilling: its sign. "
       "agrees: simulated as said, without and with "
       "drilling torque."},
      {"top", "h_over_r", "i3_over_i1", "region", "spin_over", "spin", "radius", "says", "theta_ratio",
       "does", "rate_drilling", "power", "does_drilling", "agrees", "agrees_drilling"},
      {}};
  int cases = 0, wrong = 0, wrong_drilling = 0, unfinished = 0;
  for (const Point& p : points()) {
    Setting s = p.setting;
    const double x = s.h() / s.r(), y = s.top.i3 / s.top.i1;
    const bool conditional = p.region == "II" || p.region == "IV";
    const double unit = conditional ? std::sqrt(-s.a() * s.weight() / (s.top.i1 / x * (y - 1 / x)))
                                    : std::sqrt(std::abs(s.a()) * s.weight() / s.top.i1);
    const std::vector<double> times = conditional ? std::vector{0.75, 1.33} : std::vector{0.5, 2.0};
    for (const double over : times) {
      const double spin = over * unit;
      if (p.top == "of this shape") s.radius = radius_for(s, spin);
      const bool stable =
          p.region == "III" || (p.region == "II" && over > 1) || (p.region == "IV" && over < 1);
      s.drilling = false;
      const double slowest = modes(linearised(s, spin)).eigenvalue[0].real();
      const Fate f = fate(s, spin, 8 / std::abs(slowest));
      const std::string does = f.ratio > 10 ? "grows" : f.ratio < 0.1 ? "decays" : "undecided";
      s.drilling = true;
      auto all = slow_modes(s, spin);
      const auto leading = std::max_element(
          all.begin(), all.end(), [](const SlowMode& a, const SlowMode& b) { return a.rate < b.rate; });
      const Growth g = growth(s, spin, *leading);
      const std::string does_drilling = g.rate > 0 ? "grows" : "decays";
      const std::string says = stable ? "decays" : "grows";
      ++cases;
      wrong += does != says;
      wrong_drilling += does_drilling != says;
      unfinished += !f.watch.finished || !g.watch.finished;
      table.add({p.top, x, y, p.region, over, spin, s.radius, says, f.ratio, does, g.rate,
                 g.rate * spin / std::abs(spin_rate(s, spin)), does_drilling,
                 std::string(does == says ? "1" : "0"), std::string(does_drilling == says ? "1" : "0")});
    }
  }
  contensou::write_table(table, folder / "fig11_simulated.tsv");
  const std::string of = " of " + std::to_string(cases);
  record.add(
      Claim{"stability.points", "LG03 Fig. 11",
            "points where the nonlinear top without drilling torque does not do what the diagram says," + of,
            0, static_cast<double>(wrong + unfinished), static_cast<double>(wrong + unfinished), 0, true});
  record.add(Claim{"stability.points.drilling", "LG03 Fig. 11",
                   "points where with its drilling torque it does not, while the spin loses 1 %," + of, 0,
                   static_cast<double>(wrong_drilling), static_cast<double>(wrong_drilling), 0, false});
}

}  // namespace verify::stability
