#pragma once

#include <string>
#include <vector>

#include "contensou/contact/acceleration_level.hpp"
#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/impact_law.hpp"
#include "contensou/integrate/contact_dynamics.hpp"
#include "contensou/integrate/motion.hpp"

namespace contensou {

/// What is zero at an instant, by rounding or by decision.
struct InstantTolerances {
  double approach;  ///< γ_N of this size is no impact and no departure [m/s]
  double bounce;    ///< nor is it a departure from an impact at up to this speed [m/s]
  double slip;      ///< slip slower than this (slip_speed) is over if the contact can hold [m/s]
  double length;    ///< the system's [m]
};

/// What becomes of the contacts at one instant of time, by the set-valued laws: impacts on velocity level
/// (impact_law.hpp), then which contacts open, stick or slip on acceleration level (acceleration_level.hpp).
/// Positions do not change.
class ContactInstant {
 public:
  ContactInstant(const MechanicalSystem& system, double solver_tolerance);

  /// `modes` says which contacts are closed (slip or stick: no matter) on entry and is decided anew: impacts
  /// are solved where a closed contact approaches; contacts that move apart open; of the others γ_N is set to
  /// zero, and γ_F where it is slower than `tolerances.slip`; and the forces decide which of them open, which
  /// stick and which slip. One that begins to slip from rest is given a slip velocity of twice that, in the
  /// direction its force on the border says.
  ///
  /// What impacts take out is added to `dissipated`; `report` counts. Returns false, with
  /// report.status and report.message, where a contact problem has no solution that is found.
  bool settle(State& state, std::vector<ContactMode>& modes, const InstantTolerances& tolerances,
              RunReport& report);
  /// Whether the last settle() had an impact in this contact.
  bool struck(std::size_t contact) const { return struck_[contact]; }

  /// γ_N = 0 of all closed contacts by impulses along the normal, in contacts that slip with the friction
  /// that goes with them: what impacts too small to be solved one by one do together.
  void close(State& state, const std::vector<ContactMode>& modes, RunReport& report);
  /// γ_N = 0 of closed contacts, γ_F = 0 of those that stick, by the least change of velocity.
  void correct_velocities(State& state, const std::vector<ContactMode>& modes, RunReport& report);
  /// g_N = 0 of closed contacts, by the least change of position in the metric of M.
  void correct_positions(State& state, const std::vector<ContactMode>& modes);

 private:
  /// One velocity to be set.
  struct Target {
    std::size_t contact;
    int row;
    double velocity;
    double given = 0;  ///< w̃ of the row
  };

  void gather(const State& state, const std::vector<ContactMode>& modes);
  void set_up(ContactProblem& problem) const;
  bool finite(const ContactProblem& problem, const State& state, RunReport& report) const;
  bool impact(State& state, const InstantTolerances& tolerances, RunReport& report);
  void drop_departed(const State& state, std::vector<ContactMode>& modes,
                     const InstantTolerances& tolerances);
  void stop_slow_slip(State& state, const InstantTolerances& tolerances, RunReport& report);
  bool decide(State& state, std::vector<ContactMode>& modes, const InstantTolerances& tolerances,
              RunReport& report);
  /// Of dependent contacts, forces can be shared in more than one way, and the one found may put on the
  /// border a contact that nothing makes slip (`still_`). If its slip was at the cost of one that sticks, it
  /// sticks.
  void hold_still(State& state, std::vector<ContactMode>& modes, const InstantTolerances& tolerances,
                  RunReport& report);
  bool slips(std::size_t contact, const InstantTolerances& tolerances, double part = 1) const;
  /// Sets the velocities of targets_.
  void apply(State& state, RunReport& report);
  bool solved(const SolverReport& solver, const State& state, const char* what, RunReport& report) const;

  const MechanicalSystem& system_;
  bool drives_;  ///< system.driven()
  ContactSolver solver_;
  std::vector<SlipFriction> friction_;
  std::vector<ContactRows> rows_;
  std::vector<std::size_t> closed_;
  std::vector<std::size_t> still_;  ///< at rest, force on the border, and no acceleration of slip
  std::vector<bool> at_rest_;       ///< γ_F is zero
  std::vector<bool> struck_;
  std::vector<Target> targets_;
  ConstraintSolver constraints_, gaps_;
  Eigen::VectorXd move_, rates_;
};

}  // namespace contensou
