#pragma once

#include <memory>
#include <string>
#include <vector>

#include "contensou/integrate/motion.hpp"

namespace verify::integrators {

/// A motion whose end is known, from one or more starts (several where it matters where in a step an impact
/// falls).
struct Motion {
  struct Path {
    contensou::State start;
    contensou::State end;  ///< known
    double last_closing;   ///< known time of the last closing or accumulation [s]; unused where not `timed`
  };
  std::string phase;      ///< short name
  std::string what;       ///< one line
  std::string reference;  ///< where the end is known from
  std::shared_ptr<const contensou::MechanicalSystem> system;
  double rate;  ///< scale of velocities [1/s]
  std::vector<Path> paths;
  std::vector<double> steps;            ///< of rk4
  std::vector<double> fine_steps = {};  ///< of schemes of lower order; empty: the same
  bool timed = false;
  /// Largest differences between the reference and the one it was checked against; 0 for closed forms.
  double doubt = 0;
  double doubt_of_time = 0;  ///< [s]
};

/// In the order of the tables: smooth ones, impacts, accumulations.
std::vector<Motion> all_motions();

/// The paper's top, Section 5.4, with Hertz's pressure, and its start.
std::shared_ptr<const contensou::MechanicalSystem> paper_top();
contensou::State paper_start();

}  // namespace verify::integrators
