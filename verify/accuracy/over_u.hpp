#pragma once

#include <filesystem>

namespace accuracy {

/// How the relative errors of every contender run over u, for a plot: `data`/accuracy_over_u.tsv holds the
/// largest in each tenth of a decade from 1e-9 to 1e9, against Gauss's series away from the seam and the
/// stored tables near it.
void tabulate_over_u(const std::filesystem::path& reference, const std::filesystem::path& data);

}  // namespace accuracy
