#pragma once

#include <filesystem>

#include "record.hpp"

namespace accuracy {

/// Measures every contender over the named ranges of reference_data/accuracy/{uniform,hertz}.tsv, writes
/// `data`/accuracy.tsv, and holds the library's laws to their bound.
void measure_ulp(const std::filesystem::path& reference, const std::filesystem::path& data,
                 verify::Record& record);

}  // namespace accuracy
