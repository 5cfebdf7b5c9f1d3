#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "laws.hpp"

namespace verify::story {
namespace {

constexpr double tolerance = 1e-6;
constexpr double duration = 30;   // [s]
constexpr double interval = 0.1;  // of the samples [s]

/// What the top does at the end.
std::string end_state(const Curve& c) {
  const bool body = c.gap_body.back() < closed, tip = c.gap_tip.back() < closed;
  const std::string on = body && tip ? "both" : body ? "body" : tip ? "tip" : "air";
  return on + (c.body_sticks ? " rolls" : "");
}

}  // namespace

void try_all(const std::filesystem::path& folder, Record& record) {
  struct Pressure {
    const char* name;
    contensou::AnyFriction friction;
  };
  const std::array pressures{Pressure{"hertz", hertz()}, Pressure{"uniform", uniform()},
                             Pressure{"power:1", paraboloid()}, Pressure{"ellipsoid", ellipsoid()}};
  contensou::Table table{
      {"The top of LG03 5.4 for 30 s, event_driven at tolerance 1e-6; SI units. radius = 0: Coulomb.",
       "energy_rise: largest from one sample to the next, 0.1 s later, over the energy at the start."},
      {"pressure", "radius", "mu", "status", "theta_end", "spin_end", "omega_z_end", "contact_end",
       "energy_left", "energy_rise", "evaluations"},
      {}};
  int runs = 0, failed = 0;
  double rise = 0;
  std::array<double, 2> evaluations{};  // μ <= 0.3; more
  const auto add = [&](const Pressure& p, double radius, double mu) {
    Setting s;
    s.friction = p.friction;
    s.radius = radius;
    s.mu = mu;
    s.duration = duration;
    s.options.tolerance = tolerance;
    s.options.max_steps = 1'000'000;
    const Curve c = follow(s, interval);
    ++runs;
    failed += c.report.status != contensou::RunStatus::finished;
    double largest = 0;
    for (std::size_t k = 1; k < c.energy.size(); ++k)
      largest = std::max(largest, c.energy[k] - c.energy[k - 1]);
    largest /= c.energy[0];
    rise = std::max(rise, largest);
    double& most = evaluations[mu > 0.3];
    most = std::max(most, static_cast<double>(c.report.evaluations));
    table.add({std::string(p.name), radius, mu, std::string(contensou::name(c.report.status)), c.theta.back(),
               c.spin.back(), c.omega_z.back(), end_state(c), c.energy.back() / c.energy[0], largest,
               static_cast<double>(c.report.evaluations)});
  };
  constexpr std::array frictions{0.1, 0.3, 1.0};
  add(pressures[0], 5e-4, 0);
  for (const double mu : frictions) add({"coulomb", contensou::FrictionDisk{}}, 0, mu);
  for (const Pressure& p : pressures) {
    for (const double radius : {1e-5, 1e-4, 5e-4, 2e-3, 5e-3}) {
      for (const double mu : frictions) add(p, radius, mu);
    }
  }
  contensou::write_table(table, folder / "end_states.tsv");
  const std::string all =
      std::to_string(runs) + " runs of 30 s, R = 0 to 5e-3 m, mu = 0 to 1, four pressures and Coulomb: ";
  record.add(Claim{"story.grid.finish", "the reference solution", all + "runs that do not reach the end", 0,
                   static_cast<double>(failed), static_cast<double>(failed), 0, true});
  record.add(Claim{"story.grid.energy", "the reference solution",
                   all + "energy never rises: largest rise in 0.1 s over the energy at the start", 0, rise,
                   rise,
                   // A step errs by 2 tolerances of the energy; some fifty steps at most between samples.
                   100 * tolerance, true});
  // A second or so of computing.
  constexpr double few = 1e6;
  record.add(Claim{"story.grid.evaluations", "the reference solution",
                   all + "most evaluations of the accelerations with mu <= 0.3", 0, evaluations[0],
                   evaluations[0], few, true});
  record.add(Claim{"story.grid.evaluations.rough", "the reference solution",
                   all + "the same with mu = 1, where the top almost rolls for many seconds", 0,
                   evaluations[1], evaluations[1], few, false});
}

}  // namespace verify::story
