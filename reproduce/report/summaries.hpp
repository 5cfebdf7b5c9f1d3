#pragma once

#include <string>

#include "contensou/output/table.hpp"

namespace report {

/// What a table of data/ says, in one or a few sentences of HTML whose numbers are taken from it: the line
/// that stands above the folded table. `name` is the file's without its extension; empty for a table that no
/// sentence is known for.
std::string summary(const std::string& name, const contensou::Table& table);

}  // namespace report
