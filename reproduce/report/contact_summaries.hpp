#pragma once

#include <string>

#include "contensou/output/table.hpp"

namespace report {

// Sentences of summaries.hpp for the tables of the friction ball and of the contact problem.
std::string ball_summary(const contensou::Table& table);
std::string robustness_summary(const contensou::Table& table);
std::string consistency_summary(const contensou::Table& table);
std::string siconos_coulomb_summary(const contensou::Table& table);
std::string siconos_ball_summary(const contensou::Table& table);
/// Of a table of times and ratios with aims: which aims are reached, and with what.
std::string aims_summary(const contensou::Table& table);

}  // namespace report
