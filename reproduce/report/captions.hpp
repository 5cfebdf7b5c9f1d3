#pragma once

#include <filesystem>
#include <string>

namespace report {

/// What to read from a drawing that belongs to tables, in HTML, with numbers from the tables in `data`;
/// `name` is the drawing's file without its extension. Empty for a drawing that needs no words. Throws
/// std::out_of_range where a table is not as expected.
std::string caption(const std::string& name, const std::filesystem::path& data);

}  // namespace report
