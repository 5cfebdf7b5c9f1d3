#pragma once

#include <filesystem>

#include "record.hpp"

namespace verify::siconos {

/// R = 0: problems of 1 to 8 Coulomb contacts solved by every solver of ours and of Siconos; each one's
/// solutions judged by the other's measure, velocities compared where they are unique. Writes
/// siconos_coulomb.tsv.
void check_coulomb(Record& record, const std::filesystem::path& folder);

}  // namespace verify::siconos
