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

double energy(const Simulation& simulation) {
  const State& state = simulation.state;
  return simulation.system->kinetic_energy(state.q, state.u) + simulation.system->potential_energy(state.q);
}

std::string trajectory_head(const Simulation& simulation) {
  std::string head = "t";
  for (const std::string& column : simulation.columns) head += '\t' + column;
  for (const SystemContact& contact : simulation.system->contacts()) head += "\tmode_" + contact.name;
  return head + '\n';
}

std::string events_table(const Simulation& simulation, const std::vector<Event>& events) {
  std::string table = "t\tevent\tcontact\n";
  for (const Event& event : events) {
    table += to_text(event.t) + '\t' + name(event.kind) + '\t' +
             simulation.system->contacts()[event.contact].name + '\n';
  }
  return table;
}

}  // namespace

double EnergyLedger::relative() const {
  if (imbalance() == 0) return 0;
  return imbalance() / std::max({std::abs(initial), std::abs(final), std::abs(dissipated)});
}

Outcome run(Simulation& simulation, const std::function<void(double t)>& shown) {
  Outcome outcome;
  outcome.energy.initial = energy(simulation);
  outcome.trajectory = trajectory_head(simulation);
  std::vector<double> row;
  const auto record = [&](const Sample& sample) {
    row.clear();
    simulation.describe(sample, row);
    outcome.trajectory += to_text(sample.t);
    for (const double value : row) outcome.trajectory += '\t' + to_text(value);
    for (const ContactMode mode : sample.modes) (outcome.trajectory += '\t') += mode_name(mode);
    outcome.trajectory += '\n';
    if (shown) shown(sample.t);
  };
  const auto begin = std::chrono::steady_clock::now();
  outcome.report =
      integrate(*simulation.system, simulation.state, simulation.t_end, simulation.options, record);
  outcome.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  outcome.t = simulation.state.t;
  outcome.energy.final = energy(simulation);
  for (const Dissipation& contact : outcome.report.dissipated) outcome.energy.dissipated += contact.total();
  outcome.events = events_table(simulation, outcome.report.events);
  return outcome;
}

}  // namespace contensou
