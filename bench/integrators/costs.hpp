#pragma once

#include <vector>

#include "motion.hpp"

namespace bench {

/// What one scheme costs and gives.
struct CostRow {
  Scheme scheme;
  Story whole;  ///< the 8 s; errors and seconds only where it is told
  Errors errors;
  double seconds = 0;        ///< of the whole motion
  double seconds_early = 0;  ///< of the first second
};

/// Every integrator, both formulations, over a range of steps or tolerances: run and timed, failures
/// included.
std::vector<CostRow> measure_integrators(const Reference& reference);

}  // namespace bench
