#pragma once

#include <filesystem>
#include <string>

#include "parts.hpp"

namespace report {

/// The report page: template.html of `sources`/report with its {{placeholders}}
/// filled, style and script inlined. `report` holds data/ and figures/. Parts
/// that are missing are named in a sentence where they would stand.
std::string page(const Evidence& evidence, const std::filesystem::path& sources,
                 const std::filesystem::path& report);

}  // namespace report
