#pragma once

#include <optional>
#include <string>

#include "contensou/output/table.hpp"

namespace cli {

/// Writes a finished table, or its text, to standard output, or, where `out` is given, to that file: all of
/// it or nothing. Throws BadInput where `out` is no place for a file, std::runtime_error where standard
/// output does not take it.
void deliver(const std::string& text, const std::optional<std::string>& out);
void deliver(const contensou::Table& table, const std::optional<std::string>& out);

}  // namespace cli
