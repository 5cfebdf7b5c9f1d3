#pragma once

#include <filesystem>

#include "record.hpp"

namespace accuracy {

/// PowerLaw against every reference_data/laws/power_*.tsv: writes `data`/accuracy_power.tsv and holds phi,
/// xi, eta and f″ to a relative error of 1e-13.
void measure_power_law(const std::filesystem::path& reference, const std::filesystem::path& data,
                       verify::Record& record);

}  // namespace accuracy
