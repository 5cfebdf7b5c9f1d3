#pragma once

#include <vector>

#include "contensou/output/table.hpp"
#include "costs.hpp"

namespace bench {

/// The 8 s of LG03 5.4 with every event before the accumulation within 1e-6 s in under 50 ms, and rk4 at a
/// step of 1e-4 s a hundred times more exact than rk4_printed at equal cost. `rows` say which tolerance is
/// needed.
contensou::Table measure_integrator_aims(const Reference& reference, const std::vector<CostRow>& rows);

}  // namespace bench
