#pragma once

#include "contensou/output/table.hpp"
#include "contensou/scene/audit.hpp"

namespace cli {

/// One row for each variation and outcome.
contensou::Table audit_table(const contensou::Audit& audit, const contensou::Scene& scene, int repeat);

/// change/|reference|; 0 where nothing changed, infinite where the reference is 0.
double relative_change(const contensou::OutcomeChange& change);

}  // namespace cli
