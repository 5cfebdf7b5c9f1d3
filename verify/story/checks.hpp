#pragma once

#include <filesystem>

#include "record.hpp"
#include "run.hpp"

namespace verify::story {

/// The events of 5.4 with error bars, and where the top ends: event_story.tsv.
struct Told {
  Times hertz, uniform;
  double digits;        ///< relative change of times before the accumulation over tolerances
  double formulations;  ///< and between formulations
  // Hertz:
  double theta_8, theta_30;            ///< θ at 8 s and 30 s [rad]
  double rolling;                      ///< from when on it rolls [s]
  double least_theta, least_theta_at;  ///< of the first 0.3 s
};
Told tell_events(const std::filesystem::path& folder, Record& record);

/// What could make the paper's times: story_hypotheses.tsv, story_theta.tsv.
void weigh_hypotheses(const std::filesystem::path& folder, Record& record);

/// How long inversion takes over R: inversion_over_radius.tsv; R → 0: coulomb_limit.tsv.
void vary_radius(const std::filesystem::path& folder, Record& record);
void take_coulomb_limit(const std::filesystem::path& folder, Record& record);

/// Ends well whatever R, μ and pressure: end_states.tsv.
void try_all(const std::filesystem::path& folder, Record& record);

}  // namespace verify::story
