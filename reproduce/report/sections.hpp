#pragma once

#include <filesystem>
#include <string>

#include "contensou/output/table.hpp"

/// The sections of the page that are made of tables and their drawings, as HTML. `report` holds data/ and
/// figures/; what is missing there is named in a sentence, or left out where it is one drawing of several.
namespace report {

/// A joined table under what it says.
std::string table_section(const contensou::Table& table, const std::string& id, const std::string& title,
                          bool open);

std::string quadrature_section(const std::filesystem::path& report);
std::string accuracy_section(const std::filesystem::path& report);
std::string plates_section(const std::filesystem::path& report);
std::string ball_section(const std::filesystem::path& report);
std::string contact_section(const std::filesystem::path& report);
std::string top_section(const std::filesystem::path& report);
std::string integrators_section(const std::filesystem::path& report);
std::string scenes_section(const std::filesystem::path& report);
std::string cost_section(const std::filesystem::path& report);
std::string effects_section(const std::filesystem::path& report);

}  // namespace report
