#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "contensou/scene/measure.hpp"
#include "contensou/scene/variations.hpp"

namespace contensou {

/// What a variation changed in one outcome.
struct OutcomeChange {
  double value = 0;      ///< the outcome under the variation; NaN: it did not happen
  double reference = 0;  ///< under what it is compared with
  double change = 0;     ///< difference() of both; NaN: only one has it
};

/// What became of one variation.
struct AuditRow {
  /// "finished", else why there are no numbers: it could not be read, or did not reach the end.
  std::string status = "finished";
  double seconds = 0;     ///< wall time, the shortest of all repeats
  double time_ratio = 0;  ///< to that of what it is compared with; NaN where one did not finish
  std::int64_t steps = 0;
  std::vector<OutcomeChange> outcomes;  ///< of each measure; NaN where there is none

  bool finished() const { return status == "finished"; }
};

/// What each effect of a scene is worth: the change of its outcomes, and its time.
struct Audit {
  std::vector<MeasureScene> measures;  ///< the scene's outcomes; where it names none, see `named`
  bool named = true;                   ///< false: it names none, they are the last values of all columns
  std::vector<Variation> variations;   ///< the scene itself first
  std::vector<AuditRow> rows;          ///< one for each
};

struct AuditOptions {
  /// Times are the shortest of so many runs, the variations taking turns.
  int repeat = 3;
  /// Called before each run: how many were made, of how many, and which is next.
  std::function<void(std::size_t done, std::size_t all, const Variation& next)> progress = {};
};

/// Runs a scene and all of its variations. A variation that cannot be read or run, or takes more than fifty
/// times the scene's own time (and half a minute), is a row with its status. Throws SceneError where the scene
/// itself cannot be read, std::runtime_error where it does not reach its end, and as compose() does.
Audit audit(const SceneDocument& document, const AuditOptions& options);

}  // namespace contensou
