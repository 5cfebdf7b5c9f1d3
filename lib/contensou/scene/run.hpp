#pragma once

#include <functional>
#include <string>
#include <vector>

#include "contensou/scene/simulation.hpp"

namespace contensou {

/// Where the energy went, by the books: E_0 + supplied = E_1 + dissipated + imbalance. The imbalance is the
/// scheme's error, and is not hidden in any account.
struct EnergyLedger {
  double initial = 0;     ///< kinetic + potential at the start [J]
  double supplied = 0;    ///< by loads and driven bodies, less what the air took [J]
  double final = 0;       ///< kinetic + potential at the end [J]
  double dissipated = 0;  ///< by all contacts and effects [J]

  double imbalance() const { return initial + supplied - final - dissipated; }
  /// imbalance/max(|initial|, |supplied|, |final|, |dissipated|); 0 where all are 0.
  double relative() const;
};

/// What a run made.
struct Outcome {
  RunReport report;
  EnergyLedger energy;
  double t = 0;                       ///< how far it came [s]
  double wall_seconds = 0;            ///< of the integration alone
  std::vector<std::string> contacts;  ///< names, by the report's indices
  std::vector<std::string> works;     ///< names of report.work
  std::vector<std::string> columns;   ///< of `rows`: "t", and the simulation's
  std::vector<double> rows;           ///< the trajectory, row after row
  std::vector<ContactMode> modes;     ///< of the contacts, row after row; empty where the method has none

  std::size_t row_count() const { return columns.empty() ? 0 : rows.size() / columns.size(); }
};

/// Runs a simulation to its end, or as far as it comes (the report says so); `state` is moved on. `shown` is
/// called with the time of each row. Throws as integrate() does.
Outcome run(Simulation& simulation, const std::function<void(double t)>& shown = {});

/// As tables without comments: t, the simulation's columns, mode_NAME of each contact; and t event contact.
std::string trajectory_table(const Outcome& outcome);
std::string events_table(const Outcome& outcome);

}  // namespace contensou
