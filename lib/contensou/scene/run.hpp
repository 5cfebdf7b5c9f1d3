#pragma once

#include <functional>
#include <string>

#include "contensou/scene/simulation.hpp"

namespace contensou {

/// Where the energy went, by the books: E_0 = E_1 + dissipated + imbalance. The imbalance is the scheme's
/// error, and is not hidden in any account.
struct EnergyLedger {
  double initial = 0;     ///< kinetic + potential (0 at z = 0) at the start [J]
  double final = 0;       ///< the same at the end [J]
  double dissipated = 0;  ///< by all contacts and effects [J]

  double imbalance() const { return initial - final - dissipated; }
  /// imbalance/max(|initial|, |final|, |dissipated|); 0 where all are 0.
  double relative() const;
};

/// What a run made.
struct Outcome {
  RunReport report;
  EnergyLedger energy;
  double t = 0;             ///< how far it came [s]
  double wall_seconds = 0;  ///< of the integration alone
  std::string
      trajectory;      ///< a table without comments: t, the simulation's columns, mode_NAME of each contact
  std::string events;  ///< a table without comments: t event contact
};

/// Runs a simulation to its end, or as far as it comes (the report says so); `state` is moved on. `shown` is
/// called with the time of each row. Throws as integrate() does.
Outcome run(Simulation& simulation, const std::function<void(double t)>& shown = {});

}  // namespace contensou
