#pragma once

#include <filesystem>

#include "record.hpp"

namespace verify::siconos {

/// R > 0: one contact with Coulomb–Contensou friction, its patch cut into N point contacts of the given
/// pressure and solved by Siconos, against our solution with four rows. Writes siconos_patch.tsv.
void check_patch(Record& record, const std::filesystem::path& folder);

/// The friction ball of N points, a Minkowski sum of N disks, against ours: their distance (Hausdorff) over
/// N. Writes siconos_ball.tsv.
void check_ball(Record& record, const std::filesystem::path& folder);

}  // namespace verify::siconos
