#pragma once

#include <filesystem>
#include <vector>

#include "contensou/output/file.hpp"

namespace cli {

/// Before a long run, not after it: whether results can be written into this folder, there or not; BadInput
/// for --out where they cannot. Makes nothing.
void require_writable(const std::filesystem::path& folder);

/// Writes files that belong together, all or none: signals that would end the program wait until it is done.
void write_together(const std::vector<contensou::FileText>& files);

}  // namespace cli
