#pragma once

#include <string>

namespace contensou {

/// [outcome.NAME]: one number that a run is judged by, and compared by with other runs.
struct MeasureScene {
  enum class Kind {
    final,       ///< last value of a column of the trajectory
    minimum,     ///< least value of a column over the rows of the trajectory
    maximum,     ///< greatest
    crossing,    ///< when a column first crosses `value` [s], linear between rows; NaN: never
    event,       ///< when an event happened for the occurrence-th time [s]; NaN: not so often
    count,       ///< how often it happened
    trajectory,  ///< root mean square over time of a column; between two runs, of its difference
  };
  std::string name;
  Kind kind = Kind::final;
  std::string column;   ///< all but event, count; such as "theta", "top.z", "energy"
  std::string event;    ///< "close", "open", "accumulation", "stick", "slip", "spin"
  std::string contact;  ///< of the event
  int occurrence = 1;   ///< >= 1
  double value = 0;
};

const char* name(MeasureScene::Kind kind);

}  // namespace contensou
