#include "contensou/scene/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

const char* mode_name(ContactMode mode) {
  switch (mode) {
    case ContactMode::open:
      return "open";
    case ContactMode::slip:
      return "slip";
    case ContactMode::stick:
      return "stick";
  }
  return "";
}

}  // namespace

double EnergyLedger::relative() const {
  if (imbalance() == 0) return 0;
  return imbalance() /
         std::max({std::abs(initial), std::abs(supplied), std::abs(final), std::abs(dissipated)});
}

Outcome run(Simulation& simulation, const std::function<void(double t)>& shown) {
  Outcome outcome;
  outcome.contacts = simulation.contacts;
  outcome.works = simulation.works;
  outcome.columns = {"t"};
  outcome.columns.insert(outcome.columns.end(), simulation.columns.begin(), simulation.columns.end());
  outcome.energy.initial = simulation.energy(simulation.state);
  const auto record = [&](const Sample& sample) {
    outcome.rows.push_back(sample.t);
    simulation.describe(sample, outcome.rows);
    outcome.modes.insert(outcome.modes.end(), sample.modes.begin(), sample.modes.end());
    if (shown) shown(sample.t);
  };
  const auto begin = std::chrono::steady_clock::now();
  outcome.report = simulation.advance(simulation.state, simulation.t_end, simulation.options, record);
  outcome.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  outcome.t = simulation.state.t;
  outcome.energy.final = simulation.energy(simulation.state);
  for (const Dissipation& contact : outcome.report.dissipated) {
    outcome.energy.dissipated += contact.total();
    outcome.energy.supplied += contact.driven;
  }
  for (const double work : outcome.report.work) outcome.energy.supplied += work;
  return outcome;
}

std::string trajectory_table(const Outcome& outcome) {
  const std::size_t rows = outcome.row_count();
  const std::size_t width = outcome.columns.size();
  const std::size_t modes = rows == 0 ? 0 : outcome.modes.size() / rows;
  std::string table;
  for (const std::string& column : outcome.columns) table += (table.empty() ? "" : "\t") + column;
  for (std::size_t i = 0; i < modes; ++i) table += "\tmode_" + outcome.contacts[i];
  table += '\n';
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < width; ++i)
      (table += i == 0 ? "" : "\t") += to_text(outcome.rows[row * width + i]);
    for (std::size_t i = 0; i < modes; ++i) (table += '\t') += mode_name(outcome.modes[row * modes + i]);
    table += '\n';
  }
  return table;
}

std::string events_table(const Outcome& outcome) {
  std::string table = "t\tevent\tcontact\n";
  for (const Event& event : outcome.report.events)
    table += to_text(event.t) + '\t' + name(event.kind) + '\t' + outcome.contacts[event.contact] + '\n';
  return table;
}

}  // namespace contensou
