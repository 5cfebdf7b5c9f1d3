#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "shipped.hpp"
#include "slide_to_rest.hpp"
#include "worst.hpp"

namespace verify::answers {
namespace {

// The file's data.
constexpr double m = 0.17, radius = 3.81e-2, mu = 0.1, g = 9.81, v0 = 2, spin = 30;

struct Pressure {
  const char* name;
  const char* value;  ///< of the scene's key
  double n;
};
constexpr Pressure pressures[] = {
    {"uniform", "uniform", 0}, {"hertz", "hertz", 0.5}, {"paraboloid", "power:1", 1}};

struct Body {
  const char* name;
  double kappa;
};
constexpr Body bodies[] = {{"a dome with most of its mass inside", 0.15},
                           {"a cone", 0.3},
                           {"the puck", 0.5},
                           {"a ring on a full base", 1}};
/// More of them, for the limits.
constexpr Body more_bodies[] = {{"a body", 0.2}, {"a body", 0.35}, {"a body", 0.6}};

using contensou::to_text;

Shipped slide(const Pressure& pressure, double kappa, double v, std::vector<std::string> more = {}) {
  more.insert(more.end(), {accurate, "contact.ice.pressure=\"" + std::string(pressure.value) + '"',
                           "body.puck.inertia=" + to_text(kappa * m * radius * radius),
                           "body.puck.velocity=[" + to_text(v) + ", 0, 0]"});
  return Shipped("sliding_disc", more);
}

/// What the steps can add up to in quantities relative to the motion's: ten times their tolerances, since
/// friction near the end is weaker than μλ_N, and there are several components.
double allowed(const Shipped& run) { return 10 * run.steps_error() + oracle_error; }

/// 1/p in |u − u*| ∝ s^(1/p) near the limit: (κξ/η − u) has this slope there.
double approach(const Patch& patch, double kappa, double limit) {
  const auto lag = [&](double u) {
    const auto [xi, eta] = patch.at(u, 1);
    return kappa * xi / eta - u;
  };
  const double step = 1e-5;  // error of the difference: its square
  return (lag(limit + step) - (limit > step ? lag(limit - step) : -lag(step))) / (2 * step);
}

/// Stopping time, path, turn, and u all the way.
void check_motion(const Pressure& pressure, const Body& body, Sheet& sheet) {
  const Patch patch(pressure.n);
  const double s0 = spin * radius, a = mu * g;
  const SlideToRest answer(patch, a, body.kappa, v0, s0);
  const double stop = answer.stopping_time();
  const Shipped run = slide(pressure, body.kappa, v0);
  const std::string id = std::string("disc.") + pressure.name + '.' + to_text(body.kappa) + '.';
  const std::string what =
      std::string(pressure.name) + " pressure, " + body.name + " (κ = " + to_text(body.kappa) + ")";
  const std::string by = "GSL on v' = −μg ξ, (ωR)' = −μg η/κ, ξ and η by quadrature";
  const double share = allowed(run);
  sheet.compare({id + "stop", "sliding_disc", what + ": sliding and spinning stop together at [s]", by, stop,
                 run.measured("stops"), 0, stop * share});
  sheet.compare({id + "path", "sliding_disc", what + ": path [m]", by, answer.slid(), run.measured("path"), 0,
                 (v0 + s0) * stop * share});
  Worst ratio;
  const std::vector<double> times = run.times_until(0.999 * stop);
  const std::vector<SlideToRest::Point> points = answer.at(times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double expected = points[i].ratio();
    const double bound = (1 + expected * expected) * share / (1 - times[i] / stop);
    ratio.add(std::abs(run.at("ratio_ice", i) - expected) / bound);
  }
  sheet.add({id + "ratio", "sliding_disc", what + ": v/(ωR) all the way, largest error over its bound", by, 0,
             ratio.value(), ratio.value(), 1});
  sheet.add({id + "rest", "sliding_disc", what + ": number of stops, and no speed and spin after it [m/s]",
             "both at once", 1, static_cast<double>(run.times(contensou::EventKind::stick).size()),
             std::abs(static_cast<double>(run.times(contensou::EventKind::stick).size()) - 1) +
                 std::abs(run.last("puck.vx")) + radius * std::abs(run.last("puck.wz")),
             0});
}

/// u when 1e-5 of the time is left, beside the limit.
void check_limit(const Pressure& pressure, const Body& body, Sheet& sheet, contensou::Table& measured) {
  const Patch patch(pressure.n);
  const double limit = final_ratio(patch, body.kappa), left = 1e-5, s0 = spin * radius;
  const double power = std::isinf(limit) ? 0 : approach(patch, body.kappa, limit);
  const std::string id = std::string(pressure.name) + '.' + to_text(body.kappa);
  const std::string what =
      std::string(pressure.name) + " pressure, " + body.name + " (κ = " + to_text(body.kappa) + ')';
  for (const double u : {0.1, 3.0}) {
    const SlideToRest answer(patch, mu * g, body.kappa, u * s0, s0);
    const double late = (1 - left) * answer.stopping_time();
    const Shipped run =
        slide(pressure, body.kappa, u * s0, {"scene.duration=" + to_text(late), "output.interval=10"});
    const double ratio = run.last("ratio_ice"), expected = answer.at(late).ratio();
    measured.add({std::string(pressure.name), body.kappa, u, ratio, limit});
    const std::string from = what + ", from v/(ωR) = " + to_text(u);
    sheet.compare({"disc.late." + id + ".from" + to_text(u), "sliding_disc",
                   from + ": v/(ωR) when 1e-5 of the time is left", "GSL", expected, ratio, 0,
                   (1 + expected * expected) * allowed(run) / left});
    // To infinity, or as slowly as a logarithm: there is nothing to be near to.
    if (!(power > 0.1)) continue;
    // e^−60 is left, or what it takes to get away from u = 0 first, at about half the rate.
    sheet.compare({"disc.limit." + id + ".from" + to_text(u), "sliding_disc",
                   from + ": v/(ωR) in the end, by GSL alone",
                   "uη/ξ = κ; near it |u − u*| ∝ (ωR)^" + to_text(std::round(power * 1000) / 1000), limit,
                   late_ratio(patch, body.kappa, u, 60 / power), 0, oracle_error * 10});
  }
  if (limit > 0 && std::isfinite(limit)) {
    const Shipped run = slide(pressure, body.kappa, limit * s0);
    const double stop = SlideToRest(patch, mu * g, body.kappa, limit * s0, s0).stopping_time();
    Worst strays;
    for (std::size_t i = 0; i < run.rows() && run.at("t", i) < 0.99 * stop; ++i)
      strays.add(std::abs(run.at("ratio_ice", i) - limit));
    sheet.add(
        {"disc.stays." + id, "sliding_disc",
         what + ": what starts at the limit stays there, until 1 % of the time is left: largest change of "
                "v/(ωR)",
         "u' = 0", limit, limit + strays.value(), strays.value(), (1 + limit * limit) * allowed(run) / 0.01});
  }
}

/// That q(u) falls, and its three values.
void check_uniqueness(Sheet& sheet) {
  for (const Pressure& pressure : pressures) {
    const Patch patch(pressure.n);
    const Limits border = limits(pressure.n);
    int rises = 0;
    double before = border.spins_only;
    for (double u = 1e-3; u < 1e3; u *= 1.02) {
      const double q = ratio(patch, u);
      if (!(q < before)) ++rises;
      before = q;
    }
    sheet.add({std::string("disc.unique.") + pressure.name, "sliding_disc",
               std::string(pressure.name) +
                   " pressure: q = uη/ξ falls, so that there is one limit: rises on a grid of u",
               "proof in verify/scenes/slide_to_rest.hpp", 0, static_cast<double>(rises),
               static_cast<double>(rises), 0});
    const double largest =
        std::max({std::abs(ratio(patch, 1e-7) - border.spins_only), std::abs(ratio(patch, 1) - border.equal),
                  std::abs(ratio(patch, 1e7) - border.slides_only)});
    sheet.add({std::string("disc.borders.") + pressure.name, "sliding_disc",
               std::string(pressure.name) +
                   " pressure: q at u = 0, 1, ∞ is 2/(3 + 2n), 1/(3 + 2n), 1/(4 + 2n): largest error",
               "₂F₁ at its ends", 0, largest, largest, oracle_error});
  }
  const double puck = final_ratio(Patch(0), 0.5);
  sheet.compare({"disc.published", "sliding_disc",
                 "uniform pressure, the puck: limit of v/(ωR), as published",
                 "0.653, Farkas et al., PRL 90 (2003) 248302", 0.653, puck, 0, 5e-4});
}

/// u* over κ, and u over time for the cone.
void write_curves(const std::filesystem::path& folder) {
  contensou::Table over_kappa{{"Where u = v/(ωR) of a sliding and spinning body ends over κ = I/(mR²): uη/ξ "
                               "= κ, by quadrature. 0: without slip; "
                               "inf: without spin."},
                              {"kappa", "uniform", "hertz", "paraboloid"},
                              {}};
  for (int k = 150; k <= 750; ++k) {
    std::vector<contensou::Table::Cell> row{k / 1000.0};
    for (const Pressure& pressure : pressures) row.emplace_back(final_ratio(Patch(pressure.n), k / 1000.0));
    over_kappa.add(row);
  }
  contensou::write_table(over_kappa, folder / "scenes_limits.tsv");

  contensou::Table over_time{{"u = v/(ωR) of scenes/sliding_disc.toml with the inertia of a cone, κ = 0.3, "
                              "over the part of its time that is left; "
                              "event_driven, tolerance 1e-12.",
                              "start: u at the start; limit: u* by quadrature."},
                             {"pressure", "start", "limit", "left", "u"},
                             {}};
  constexpr double cone = 0.3;
  for (const Pressure& pressure : pressures) {
    const double limit = final_ratio(Patch(pressure.n), cone);
    for (const double start : {0.1, 0.4, 1.0, 2.0, 3.0}) {
      const Shipped run = slide(pressure, cone, start * spin * radius, {"output.interval=5e-4"});
      const double stop = run.measured("stops");
      double shown = 2;  // what was left at the last row of the table
      for (std::size_t i = 0; i < run.rows() && run.at("t", i) < stop; ++i) {
        const double left = 1 - run.at("t", i) / stop;
        if (left > 0.9 * shown) continue;
        shown = left;
        over_time.add({std::string(pressure.name), start, limit, left, run.at("ratio_ice", i)});
      }
    }
  }
  contensou::write_table(over_time, folder / "scenes_disc.tsv");
}

}  // namespace

void check_sliding_disc(const std::filesystem::path& folder, Sheet& sheet) {
  check_uniqueness(sheet);
  contensou::Table measured{
      {"u = v/(ωR) of scenes/sliding_disc.toml when 1e-5 of the time until it stops is left, from u = start; "
       "event_driven, tolerance 1e-12. limit: u* by quadrature."},
      {"pressure", "kappa", "start", "u", "limit"},
      {}};
  for (const Pressure& pressure : pressures) {
    for (const Body& body : bodies) {
      check_motion(pressure, body, sheet);
      check_limit(pressure, body, sheet, measured);
    }
    for (const Body& body : more_bodies) check_limit(pressure, body, sheet, measured);
  }
  contensou::write_table(measured, folder / "scenes_disc_ends.tsv");
  write_curves(folder);
}

}  // namespace verify::answers
