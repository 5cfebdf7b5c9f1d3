#pragma once

#include <filesystem>
#include <string>

#include "contensou/output/table.hpp"

namespace report {

/// What a table of data/ says, in one or a few sentences of HTML whose numbers are taken from it: the line
/// that stands above the folded table. `name` is the file's without its extension; empty for a table that no
/// sentence is known for.
std::string summary(const std::string& name, const contensou::Table& table);

/// What to read from the drawing of the errors over u (accuracy_over_u.tsv, and accuracy_loss.tsv for where
/// they reach 1).
std::string accuracy_caption(const std::filesystem::path& data);

}  // namespace report
