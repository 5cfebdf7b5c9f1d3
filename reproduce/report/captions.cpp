#include "captions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "contensou/output/table.hpp"
#include "number.hpp"
#include "selection.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

std::string accuracy(const fs::path& data) {
  const Table over_u_table = contensou::read_table(data / "accuracy_over_u.tsv");
  const Table loss_table = contensou::read_table(data / "accuracy_loss.tsv");
  const Selection over_u(over_u_table), loss(loss_table);
  // Where the relative error of η first passes 1 on the way out.
  const auto lost = [&](const char* method) {
    const Selection row = loss.where("method", method)
                              .where("quantity", "eta")
                              .where("towards", "infinity")
                              .where("threshold", "1");
    return row.empty() ? std::string("(never)") : rounded(row.first("u"), 2);
  };
  return fmt::format(
      "Largest relative error in each tenth of a decade of <i>u</i>; the level line is 2<sup>−53</sup>, the "
      "most that "
      "rounding the exact value can cost. This library stays beside it, at most {}, from end to end. Slopes "
      "are digits "
      "lost by cancellation: of <i>η</i> none is left beyond <i>u</i> = {} with K and E, {} with Carlson’s "
      "integral, {} "
      "with (3.18) as printed. The peaks at <i>u</i> = 1 are not rounding: there the series (2.8), (2.13), "
      "(2.14) as "
      "printed are off by up to {}. What is below 10<sup>−17</sup> is drawn there.",
      rounded_up(over_u.where("method", "exact").largest("error"), 2), lost("textbook_ke_boost"),
      lost("carlson_boost"), lost("printed"),
      rounded(over_u.where("method", "printed_series").largest("error"), 2));
}

std::string cost_projection(const fs::path& data) {
  const Table table = contensou::read_table(data / "cost_projection.tsv");
  const auto of = [&](const char* method, const char* pressure) {
    return Selection(table).where("pressure", pressure).where("method", method);
  };
  return fmt::format(
      "Largest error of the nearest point, in <i>μλ<sub>N</sub></i>, over the time of one projection; the "
      "halo "
      "is the Pareto front, the dotted line the aim of 300 ns. The exact projection takes {:.0f} ns "
      "(uniform) "
      "and {:.0f} ns (Hertz), the ellipsoid’s {:.0f} and {:.0f} ns: where that one stands in for the ball, "
      "the "
      "friction force is off by up to {} and {} <i>μλ<sub>N</sub></i>, on the disk × interval by up to {}.",
      of("exact", "uniform").first("seconds") * 1e9, of("exact", "hertz").first("seconds") * 1e9,
      of("ellipsoid", "uniform").first("seconds") * 1e9, of("ellipsoid", "hertz").first("seconds") * 1e9,
      rounded(of("ellipsoid", "uniform").first("error"), 2),
      rounded(of("ellipsoid", "hertz").first("error"), 2),
      rounded(of("decoupled", "uniform").first("error"), 2));
}

// Iterations of the paper's method with the best r given, and with the automatic one.
std::string augmented_r(const fs::path& data) {
  const Table table = contensou::read_table(data / "augmented_r.tsv");
  const Selection sticking = Selection(table).where("case", "body_stick");
  const Selection automatic = sticking.where("method", "automatic");
  return fmt::format(
      "Iterations of the paper’s Modified Newton method, LG03 (4.17), on contacts of the tippe-top of "
      "Section "
      "5.4 over the parameter <i>r</i>, in units of 2/<i>λ</i><sub>max</sub>(<b>W</b>). Halving <i>r</i> "
      "doubles "
      "the iterations; where a contact sticks, none converges beyond 1, and near it the torque’s small row "
      "(∝ <i>R</i>²) still asks for thousands: the best <i>r</i> tried takes {} where the body sticks, the "
      "automatic choice (dots) {}.",
      rounded(sticking.where("method", "given").least_there_is("iterations_1e10"), 3),
      rounded(automatic.first("iterations_1e10"), 3));
}

std::string cost_solvers(const fs::path&) {
  return "Largest residual, one measure for all solvers, over the time of one problem from a cold start. "
         "Hollow: "
         "the solver leaves problems unsolved. Halo: Pareto front of those that solve all of the family. "
         "Orange: Siconos.";
}

std::string cost_integrators(const fs::path& data) {
  const Table table = contensou::read_table(data / "cost_integrators.tsv");
  const auto of = [&](const char* method, const char* setting) {
    return Selection(table).where("method", method).where("setting", setting);
  };
  const Selection best = of("event_driven", "axis, tolerance 1e-11"), rk4 = of("rk4", "axis, step 1e-04"),
                  printed = of("rk4_printed", "axis, step 1e-04");
  return fmt::format(
      "Largest error of the times of all impacts before they accumulate, over the time of the 8 s of Section "
      "5.4, and error of the inclination after 1 s, over the time of that. Event-driven with a tolerance of "
      "10<sup>−11</sup>: {} s in {:.0f} ms. With steps of 10<sup>−4</sup> s Runge–Kutta 4 as printed leaves "
      "{} s, this library’s {} s, in {:.2g} of the time. Hollow: in Euler angles; the top passes within "
      "2·10<sup>−4</sup> rad of their singularity at 0.1441 s, where most fixed steps fail or lose their "
      "accuracy.",
      rounded_up(best.first("error"), 2), best.first("seconds") * 1e3, rounded(printed.first("error"), 2),
      rounded_up(rk4.first("error"), 2), rk4.first("seconds") / printed.first("seconds"));
}

std::string cost_bodies(const fs::path& data) {
  const Table table = contensou::read_table(data / "cost_bodies.tsv");
  const auto of = [&](const char* bodies, const char* threads) {
    return Selection(table).where("bodies", bodies).where("threads", threads);
  };
  const Selection one = of("2000", "1"), two = of("2000", "2");
  return fmt::format(
      "Time of a step of nscd over the number of balls that drop into a box, to a solver tolerance of "
      "10<sup>−6</sup>, with a line of slope 1. 2000 balls: {} ms a step, {:.2g} times as fast with two "
      "threads and the same result to the last bit.",
      rounded(one.first("seconds") * 1e3, 2), one.first("seconds") / two.first("seconds"));
}

std::string robustness(const fs::path&) {
  return "Share of the random problems solved to 10<sup>−10</sup> within a time per problem, from a cold "
         "start.";
}

std::string siconos_patch(const fs::path& data) {
  const Table table = contensou::read_table(data / "siconos_patch.tsv");
  const Selection sticking = Selection(table).where("motion", "sticking").where("set", "rings");
  return fmt::format(
      "The patch cut into <i>N</i> point contacts with Coulomb friction, solved by Siconos, against our "
      "solution "
      "with four rows. Above: force or velocity; the points come to our law as fast as they integrate the "
      "pressure, geometrically where the point of no slip lies outside the patch (<i>u</i> = 2) and like "
      "1/<i>N</i> "
      "where it lies inside, and agree to {} where the contact sticks (the solver’s own tolerance). Below: "
      "the "
      "set itself, the Minkowski sum of <i>N</i> disks against the friction ball.",
      rounded_up(sticking.where("points", "256").largest("error"), 2));
}

std::string integrator_orders(const fs::path& data) {
  const Table table = contensou::read_table(data / "integrator_orders.tsv");
  const auto order = [&](const char* scheme, const char* phase) {
    return rounded(Selection(table)
                       .where("scheme", scheme)
                       .where("phase", phase)
                       .where("quantity", "state")
                       .first("order"),
                   2);
  };
  return fmt::format(
      "The tippe-top: error at the end of a motion over the step, over its mean where the scheme chooses it; "
      "worst of "
      "several places of an impact in its step. Dotted: orders 1, 2, 4. Table 2 (<code>rk4_printed</code>), "
      "said to be of "
      "order four in smooth motion and one through impacts, has {} in flight, {} in slip, {} through an "
      "inelastic impact; "
      "<code>rk4</code> has {}, {}, {}. The printed schemes know no restitution.",
      order("rk4_printed", "flight"), order("rk4_printed", "slip_top"), order("rk4_printed", "impact_top"),
      order("rk4", "flight"), order("rk4", "slip_top"), order("rk4", "impact_top"));
}

std::string integrator_nutation(const fs::path& data) {
  const Table table = contensou::read_table(data / "integrator_habits.tsv");
  const auto rate = [&](const char* scheme) {
    return rounded(Selection(table)
                       .where("what", "nutation_flight")
                       .where("scheme", scheme)
                       .where("formulation", "euler")
                       .where("setting", "1e-04")
                       .where("quantity", "numerical_rate")
                       .first("value"),
                   2);
  };
  return fmt::format(
      "The nutation’s amplitude. Table 1 makes it grow until the numbers end, its fully implicit version "
      "deadens it; in "
      "flight, for a step of 10<sup>−4</sup> s, at {} and {} s<sup>−1</sup>, "
      "±<i>ω</i>²Δ<i>t</i>/2. On the floor the exact amplitude grows by slip, and with the nutation the top "
      "turns over.",
      rate("moreau_printed"), rate("moreau_implicit"));
}

// What a row of story_hypotheses.tsv says of the four times of contact.
std::string story(const fs::path& data) {
  const Table table = contensou::read_table(data / "story_hypotheses.tsv");
  const auto told = [&](const char* hypothesis) {
    const Selection row = Selection(table).where("hypothesis", hypothesis).where("method", "event_driven");
    return fmt::format("{}, {}, {}, {} s", rounded(row.first("stick_touches"), 3),
                       rounded(row.first("body_touches"), 3), rounded(row.first("double_from"), 3),
                       rounded(row.first("double_to"), 3));
  };
  return fmt::format(
      "Inclination over time; broken lines and numbers above are the paper’s: stick and body touch at 1.5 "
      "and 4.55 s, double "
      "contact from 4.65 to 5.4 s. Ours: {} (Hertz), {} (uniform), {} (ellipsoid), and {} with a projection "
      "on the friction "
      "ball along rays in place of the nearest point. Fitted: the best <i>R</i> and <i>μ</i> of a grid.",
      told("Hertz, exact"), told("uniform, exact"), told("ellipsoid"), told("radial projection, Hertz"));
}

// The limits of the homogeneous disc and the cone, as the runs end.
std::string scenes_disc(const fs::path& data) {
  const Table table = contensou::read_table(data / "scenes_disc_ends.tsv");
  const auto last = [&](const char* pressure) {
    return rounded(
        Selection(table).where("pressure", pressure).where("kappa", "0.3").where("start", "3").first("u"), 4);
  };
  return fmt::format(
      "A body slides and spins on a flat base: <i>u</i> = <i>v</i>/(<i>ωR</i>) tends to one limit from "
      "wherever it starts, and both "
      "speeds vanish together. Above: a cone, five starts; with 10<sup>−5</sup> of the time left, that from "
      "3 is at "
      "{} (uniform), {} (Hertz), {} (paraboloid). Circles: runs from 0.1 and 3, then. Below: the "
      "limit over <i>κ</i> = <i>I</i>/(<i>mR</i>²), the root of <i>uη</i>/<i>ξ</i> = <i>κ</i>; with pressure "
      "∝ (1 − "
      "<i>ρ</i>²/<i>R</i>²)<sup><i>n</i></sup> it is 0 from <i>κ</i> = 2/(3 + 2<i>n</i>) on, 1 at 1/(3 + "
      "2<i>n</i>), and infinite up to "
      "1/(4 + 2<i>n</i>). A homogeneous disc (<i>κ</i> = ½) ends at 0.653 under uniform pressure, and just "
      "does not under Hertz’s: its "
      "<i>u</i> goes to zero as slowly as 1/√(−ln <i>ω</i>).",
      last("uniform"), last("hertz"), last("paraboloid"));
}

std::string inversion_over_radius(const fs::path&) {
  return "When the stick touches and when <i>θ</i> first is π/2, over the contact radius, from the start of "
         "Section 5.4. A smaller "
         "radius inverts more slowly only below about 10<sup>−4</sup> m; the paper’s own lies beyond. Taking "
         "the drilling "
         "torque away hardly changes the inversion; but then the top stays upright for ever.";
}

// How many runs of the phase map have a time in this column, and the least spin of them.
struct Happened {
  std::size_t runs = 0;
  double least_spin = 0;
};

Happened happened(const Table& map, const char* column) {
  const std::vector<std::string> times = map.texts(column);
  const std::vector<double> spins = map.numbers("initial.psi_dot");
  Happened found;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] == "nan") continue;
    found.least_spin = found.runs == 0 ? spins[i] : std::min(found.least_spin, spins[i]);
    ++found.runs;
  }
  return found;
}

std::string phase_map(const fs::path& data) {
  const Table map = contensou::read_table(data / "phase_map.tsv");
  const Happened side = happened(map, "inversion"), stick = happened(map, "stick");
  const Table least_table = contensou::read_table(data / "phase_map_spins.tsv");
  const auto least = [&](const char* what) {
    return rounded(Selection(least_table).where("what", what).first("psi_dot"), 3);
  };
  return fmt::format(
      "When the top of Section 5.4 first lies on its side, over the contact radius of its body and its spin "
      "at "
      "the start: within 8 s {} of {} runs get there, from {:.0f} rad/s, and {} onto the stick, from {:.0f} "
      "rad/s, both with the least spin where <i>R</i> is between 10<sup>−4</sup> and 10<sup>−3</sup> m. With "
      "a "
      "smaller radius the contact rolls more and slides less, with a larger one the drilling torque takes "
      "the "
      "spin before the top is up; if sliding alone took energy, Jellet’s integral would ask for {} and {} "
      "rad/s "
      "at any radius.",
      side.runs, map.rows.size(), side.least_spin, stick.runs, stick.least_spin, least("side"),
      least("stick"));
}

}  // namespace

std::string caption(const std::string& name, const fs::path& data) {
  static const std::map<std::string, std::string (*)(const fs::path&)> captions{
      {"accuracy", accuracy},
      {"augmented_r", augmented_r},
      {"cost_integrators", cost_integrators},
      {"cost_bodies", cost_bodies},
      {"integrator_nutation", integrator_nutation},
      {"integrator_orders", integrator_orders},
      {"cost_projection", cost_projection},
      {"cost_solvers", cost_solvers},
      {"phase_map", phase_map},
      {"robustness", robustness},
      {"scenes_disc", scenes_disc},
      {"story", story},
      {"inversion_over_radius", inversion_over_radius},
      {"siconos_patch", siconos_patch}};
  const auto words = captions.find(name);
  return words == captions.end() ? "" : words->second(data);
}

}  // namespace report
