#pragma once

#include <filesystem>

#include "record.hpp"

namespace accuracy {

/// Where the formulas as printed, and the textbook's, lose their digits: scans u out to 1e9 and in to 1e-9,
/// writes `data`/accuracy_loss.tsv with the u at which the relative error first passes 1e-12, 1e-8, 1e-4 and
/// 1, and compares with the u that rounding analysis predicts.
void measure_loss(const std::filesystem::path& reference, const std::filesystem::path& data,
                  verify::Record& record);

}  // namespace accuracy
