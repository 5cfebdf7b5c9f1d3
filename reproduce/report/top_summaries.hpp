#pragma once

#include <string>

#include "contensou/output/table.hpp"

/// What the tables of the tippe-top say, as HTML; see summaries.hpp.
namespace report {

std::string top_events_summary(const contensou::Table& table);
std::string radius_events_summary(const contensou::Table& table);
std::string growth_summary(const contensou::Table& table);
std::string magnus_summary(const contensou::Table& table);

}  // namespace report
