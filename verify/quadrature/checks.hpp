#pragma once

#include <filesystem>

#include "progress.hpp"
#include "record.hpp"

namespace verify {

/// Each adds its claims to the record, writes its table into `folder`, prints one line of summary, and
/// advances the progress by one for every `steps` it announced.

/// The reduced law of σ ∝ (1 − ρ²)ⁿ, in both coordinate systems, against every formula for it.
void check_laws(Record& record, const std::filesystem::path& folder, Progress& progress);
int check_laws_steps();

/// The force vector for general γ_F, R, μ, λ_N, signs included, against friction_force.
void check_forces(Record& record, const std::filesystem::path& folder, Progress& progress);
int check_forces_steps();

/// Tabulated pressures: RadialLaw against the disc integral,
/// and what compiled laws state about their own error.
void check_radial(Record& record, const std::filesystem::path& folder, Progress& progress);
int check_radial_steps();

/// Formulas that are known to be wrong as printed, and small changes of right ones: all must be caught.
void check_printed(Record& record, Progress& progress);
int check_printed_steps();

}  // namespace verify
