#pragma once

#include <optional>
#include <vector>

#include "contensou/granular/block_solver.hpp"
#include "contensou/granular/contact_account.hpp"
#include "contensou/granular/nscd.hpp"

namespace contensou {

/// The steps of run_nscd, and all they need to remember.
class NscdStep {
 public:
  /// Layout, team, report and counts outlive it.
  NscdStep(const BodyLayout& layout, const IntegratorOptions& options, WorkerTeam& team, RunReport& report,
           NscdCounts& counts);

  /// Throws std::invalid_argument, one line, where surfaces that can touch are in each other, by
  /// more than steps of length dt leave.
  void require_apart(const State& state, double dt);
  /// Moves `state` on by dt > 0.
  void advance(State& state, double dt);

 private:
  void solve_contacts(const State& state, double dt);
  void update_reach(const std::vector<Twist>& twists, double dt);
  void choose_points();
  bool look(const State& state);
  void look_again();
  bool choose(const std::vector<Twist>& twists, double rooms, double dt);

  const BodyLayout& layout_;
  std::optional<double> fidelity_;
  RunReport& report_;
  NscdCounts& counts_;
  BodyMotion motion_;
  PairList list_;
  ContactSet set_;
  BlockSolver solver_;
  std::vector<double> room_;   ///< of each body, how near counts as touching [m]
  std::vector<double> reach_;  ///< of each body in this step [m]
  std::vector<Approach> approach_;
  std::vector<Twist> after_;
  std::vector<BodyMotion::Touch> touch_;
  std::vector<double> excess_, load_;
};

}  // namespace contensou
