#pragma once

#include <filesystem>
#include <string>

namespace report {

/// The stage on which top.js shows data/animation.tsv, with the motion in it as JSON; a note where the table
/// is not there.
std::string animation(const std::filesystem::path& report);

}  // namespace report
