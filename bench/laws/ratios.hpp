#pragma once

#include "contensou/output/table.hpp"

namespace bench {

/// How the library's laws compare with one ellint_1 plus one ellint_2 call of Boost (promotion off), and
/// batches with one value at a time: rows `ratio value aim reached`, with the quartiles over the rounds. All
/// times of a ratio come from the same round.
contensou::Table measure_ratios();

}  // namespace bench
