#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "worst.hpp"

namespace verify::story {
namespace {

using contensou::EventKind;

constexpr double duration = 30;  // [s]

/// A number of the story and what the paper has for it.
struct Entry {
  const char* name;
  const char* unit;
  double paper;
  std::function<double(const Curve&)> value;
  bool early;  ///< before the accumulation: eight digits are asked for
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"stick touches", "s", printed.tip, [](const Curve& c) { return located(c).tip; }, true},
      {"body leaves", "s", never, [](const Curve& c) { return first(c, EventKind::open, 0); }, true},
      {"upright from", "s", printed.upright_from, [](const Curve& c) { return located(c).upright_from; },
       true},
      {"theta largest", "s", printed.turning, [](const Curve& c) { return located(c).turning; }, false},
      {"upright to", "s", printed.upright_to, [](const Curve& c) { return located(c).upright_to; }, true},
      {"body touches", "s", printed.body, [](const Curve& c) { return located(c).body; }, true},
      {"double contact from", "s", printed.both_from, [](const Curve& c) { return located(c).both_from; },
       false},
      {"double contact to", "s", printed.both_to, [](const Curve& c) { return located(c).both_to; }, false},
      {"rolling from", "s", never, [](const Curve& c) { return first(c, EventKind::stick, 0); }, false},
      {"theta(8 s)", "rad", never, [](const Curve& c) { return at(c, c.theta, 8); }, false},
      {"omega_z(8 s)", "rad/s", never, [](const Curve& c) { return at(c, c.omega_z, 8); }, false},
      {"theta(30 s)", "rad", 0, [](const Curve& c) { return c.theta.back(); }, false},
      {"omega_z(30 s)", "rad/s", 0, [](const Curve& c) { return c.omega_z.back(); }, false},
      {"spin(30 s)", "rad/s", 0, [](const Curve& c) { return c.spin.back(); }, false},
      {"energy(8 s)/energy(0)", "", never, [](const Curve& c) { return at(c, c.energy, 8) / c.energy[0]; },
       false},
      {"energy(30 s)/energy(0)", "", never, [](const Curve& c) { return c.energy.back() / c.energy[0]; },
       false},
  };
  return all;
}

struct Runs {
  Curve reference;                ///< axis, 1e-12
  std::vector<Curve> tolerances;  ///< axis, 1e-11 and 1e-13
  Curve euler;                    ///< 1e-12
};

Runs runs(const contensou::AnyFriction& friction) {
  const auto run = [&](double tolerance, bool euler) {
    Setting s;
    s.friction = friction;
    s.duration = duration;
    s.euler = euler;
    s.options.tolerance = tolerance;
    return follow(s);
  };
  return {run(1e-12, false), {run(1e-11, false), run(1e-13, false)}, run(1e-12, true)};
}

struct Value {
  double ours, tolerance, formulation;
};
Value value(const Entry& e, const Runs& r) {
  const double ours = e.value(r.reference);
  Worst worst;
  for (const Curve& c : r.tolerances) worst.add(std::abs(e.value(c) - ours));
  return {ours, worst.value(), std::abs(e.value(r.euler) - ours)};
}

/// Dissipated and left at the end, against the start.
double imbalance(const Curve& c) {
  double sum = c.energy.back();
  for (const auto& d : c.report.dissipated) sum += d.total();
  return std::abs(sum / c.energy[0] - 1);
}

/// How near the axis comes to the vertical before it inverts, where Euler's angles have their singularity.
void least_inclination(Told& told) {
  Setting s;
  s.duration = 0.3;
  s.options.tolerance = 1e-12;
  const Curve c = follow(s, 1e-5);
  const auto least = std::min_element(c.theta.begin(), c.theta.end());
  told.least_theta = *least;
  told.least_theta_at = c.t[static_cast<std::size_t>(least - c.theta.begin())];
}

}  // namespace

Told tell_events(const std::filesystem::path& folder, Record& record) {
  const Runs hertz_runs = runs(hertz()), uniform_runs = runs(uniform());
  contensou::Table table{{"The story of the tippe-top, LG03 5.4: R = 5e-4 m, mu = 0.3, event_driven at "
                          "tolerance 1e-12, axis of symmetry; SI units.",
                          "tolerance: largest change at 1e-11 and 1e-13; formulation: change with Euler's "
                          "angles (LG03's coordinates).",
                          "upright: theta > 0.95 pi, which is ours (the paper names no bound), read between "
                          "samples 1 ms apart; theta "
                          "largest: its re-inversion, t > 4 s. paper: from the text of 5.4, zeros its "
                          "\"trivial non-rotating equilibrium\"."},
                         {"event", "unit", "paper", "hertz", "hertz_tolerance", "hertz_formulation",
                          "uniform", "uniform_tolerance", "uniform_formulation"},
                         {}};
  Worst digits, formulations;
  for (const Entry& e : entries()) {
    const Value h = value(e, hertz_runs), u = value(e, uniform_runs);
    if (e.early) {
      digits.add(std::max(h.tolerance / h.ours, u.tolerance / u.ours));
      formulations.add(std::max(h.formulation / h.ours, u.formulation / u.ours));
    }
    table.add({std::string(e.name), std::string(e.unit), e.paper, h.ours, h.tolerance, h.formulation, u.ours,
               u.tolerance, u.formulation});
  }
  contensou::write_table(table, folder / "event_story.tsv");

  const Curve& end = hertz_runs.reference;
  Told told;
  told.hertz = located(end);
  told.uniform = located(uniform_runs.reference);
  told.digits = digits.value();
  told.formulations = formulations.value();
  told.body_leaves = first(end, EventKind::open, 0);
  told.inverting = reaches(end, std::numbers::pi / 2);
  told.nutation = nutation(end, 0.2, told.hertz.tip);
  told.energy_at_tip = at(end, end.energy, told.hertz.tip) / end.energy[0];
  told.spin_at_turning = std::abs(at(end, end.spin, told.hertz.turning));
  for (const contensou::Event& e : end.report.events)
    told.impacts += e.kind == EventKind::close && e.t >= told.hertz.body && e.t < told.hertz.both_from;
  told.rolling = first(end, EventKind::stick, 0);
  const auto after_rolling = std::lower_bound(end.t.begin(), end.t.end(), told.rolling) - end.t.begin();
  const auto [least, largest] = std::minmax_element(end.theta.begin() + after_rolling, end.theta.end());
  told.rolls_least = *least;
  told.rolls_largest = *largest;
  told.theta_30 = end.theta.back();
  told.spin_30 = end.spin.back();
  told.energy_30 = end.energy.back() / end.energy[0];
  least_inclination(told);

  // Eight digits, as events before the accumulation are asked to have.
  constexpr double eight_digits = 5e-9;
  record.add(Claim{
      "story.events.tolerance", "the reference solution",
      "times before the accumulation, both pressures, tolerance 1e-11 ... 1e-13: largest relative change", 0,
      told.digits, told.digits, eight_digits, true});
  record.add(Claim{"story.events.formulation", "the reference solution",
                   "the same, axis of symmetry against Euler's angles", 0, told.formulations,
                   told.formulations, eight_digits, true});
  Worst balance;
  for (const Runs* r : {&hertz_runs, &uniform_runs}) {
    balance.add(imbalance(r->reference));
    balance.add(imbalance(r->euler));
  }
  record.add(Claim{"story.energy", "the reference solution",
                   "energy left and dissipated after 30 s add up to that of the start: relative difference",
                   1, 1 + balance.value(), balance.value(), 1e-9, true});
  for (const auto& [id, name, times] :
       {std::tuple{"hertz", "Hertz", told.hertz}, {"uniform", "uniform", told.uniform}}) {
    const std::string pressure = std::string(name) + " pressure: ";
    const std::string where = "LG03 5.4";
    const std::string key = std::string("story.") + id;
    const auto add = [&](const char* what, const char* sentence, double paper, double ours) {
      record.add(
          Claim{key + what, where, pressure + sentence, paper, ours, std::abs(ours - paper), reading, false});
    };
    add(".tip", "the stick touches at 1.5 s", printed.tip, times.tip);
    add(".body", "the body touches at 4.55 s", printed.body, times.body);
    add(".double.from", "double contact from 4.65 s", printed.both_from, times.both_from);
    add(".double.to", "double contact to 5.4 s", printed.both_to, times.both_to);
  }
  record.add(Claim{"story.end", "LG03 5.4",
                   "the top turns to its trivial position: theta after 30 s, Hertz [rad]", 0, told.theta_30,
                   told.theta_30, 0.01, false});
  const double rolling_loss = 1 - end.energy.back() / at(end, end.energy, std::ceil(told.rolling) + 1);
  record.add(Claim{"story.end.rolls", "the end of LG03 5.4",
                   "from where it rolls on, nothing is dissipated: relative loss of energy until 30 s, Hertz",
                   0, rolling_loss, std::abs(rolling_loss), 1e-9, true});
  return told;
}

}  // namespace verify::story
