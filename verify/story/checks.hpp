#pragma once

#include <filesystem>

#include "record.hpp"
#include "run.hpp"

namespace verify::story {

/// The story in numbers, for the ledger. Where no pressure is named, Hertz.
struct Told {
  Times hertz, uniform;
  double digits = 0;         ///< relative change of times before the accumulation over tolerances
  double formulations = 0;   ///< and between formulations
  double body_leaves = 0;    ///< [s]
  double inverting = 0;      ///< θ = π/2 [s]
  double nutation = 0;       ///< before the stick touches [rad/s]
  double energy_at_tip = 0;  ///< when the stick touches, over that at the start
  double spin_at_turning = 0;
  int impacts = 0;                             ///< from the body's touching to the accumulation
  double rolling = 0;                          ///< from when on it rolls [s]
  double rolls_least = 0, rolls_largest = 0;   ///< θ from then on [rad]
  double theta_30 = 0, spin_30 = 0;            ///< at 30 s
  double energy_30 = 0;                        ///< over that at the start
  double least_theta = 0, least_theta_at = 0;  ///< of the first 0.3 s
};
/// The events of 5.4 with error bars, and where the top ends: event_story.tsv.
Told tell_events(const std::filesystem::path& folder, Record& record);

/// What could make the paper's times: story_hypotheses.tsv, story_theta.tsv.
struct Weighed {
  int tried = 0, agreeing = 0;  ///< changes without a fitted number, and those that give all four times
  double percent = 0;  ///< largest change of the time the body touches by a percent of one of the data [s]
};
Weighed weigh_hypotheses(const std::filesystem::path& folder, Record& record);

/// How long inversion takes over R: inversion_over_radius.tsv.
struct Radii {
  double fastest = 0;     ///< R of the least time to θ = π/2 [m], Hertz, θ_0 = 0.1
  double at_fastest = 0;  ///< that time [s]
  double at_paper = 0;    ///< at R = 5e-4 m
  double at_least = 0;    ///< at the smallest R
  double at_largest = 0;
  double without_drilling =
      0;  ///< relative change of the time at R = 5e-4 m where the drilling torque is left out
  double upright_without_drilling = 0;  ///< θ at 30 s
};
Radii vary_radius(const std::filesystem::path& folder, Record& record);

/// R → 0: coulomb_limit.tsv.
struct Limit {
  double largest_rolling = 0;           ///< θ/θ_0 from a rolling start
  double precession = 0, nutation = 0;  ///< of the smallest, rolling [rad/s]
  double precession_537 = 0, nutation_537 = 0;
  int slipping = 0;             ///< slipping starts tried
  double largest_slipping = 0;  ///< θ over the larger of θ_0 and v_S/(r_1 ψ̇_0)
  double start_54 = 0;          ///< largest θ from the start of 5.4 [rad]
};
Limit take_coulomb_limit(const std::filesystem::path& folder, Record& record);

/// Ends well whatever R, μ and pressure: end_states.tsv.
void try_all(const std::filesystem::path& folder, Record& record);

/// Rows for the sentences of 5.4, 5.5 and 6 on the motion of the top.
void enter_ledger(const Told& told, const Weighed& weighed, const Radii& radii, const Limit& limit,
                  Record& record);

}  // namespace verify::story
