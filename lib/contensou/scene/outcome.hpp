#pragma once

#include <string>
#include <vector>

#include "contensou/scene/measure.hpp"
#include "contensou/scene/run.hpp"

namespace contensou {

/// What a scene that names no outcome is judged by: the last values of all columns.
std::vector<MeasureScene> last_values(const Scene& scene);

/// The number that a run gives a measure; NaN where there is none (an event that did not happen). Throws
/// std::invalid_argument with one line for a column or contact that the run does not have.
double evaluate(const MeasureScene& measure, const Outcome& outcome);

/// How far two runs of a scene are apart by a measure: the difference of their numbers, |b − a|; for
/// `trajectory` the root mean square over time of the column's difference, over the time both cover. NaN
/// where just one has none, 0 where neither has.
double difference(const MeasureScene& measure, const Outcome& a, const Outcome& b);

}  // namespace contensou
