#pragma once

#include <string>

#include "contensou/output/table.hpp"

namespace report {

/// accuracy.tsv at a glance: a table for each pressure, a row for each quantity and method, a column for each
/// range of u, in each cell the largest error in ulp, coloured by its size.
std::string accuracy_at_a_glance(const contensou::Table& accuracy);

}  // namespace report
