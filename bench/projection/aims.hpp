#pragma once

#include <filesystem>

#include "contensou/output/table.hpp"

namespace bench {

/// The aim of 300 ns for an exact projection, and what the projection costs beside one evaluation of the law
/// and beside the ellipsoid's projection: rows `quantity value aim reached`, with the quartiles over rounds.
contensou::Table measure_projection_aims(const std::filesystem::path& reference);

}  // namespace bench
