#include "contensou/integrate/dop853.hpp"
#include "contensou/integrate/hybrid_run.hpp"
#include "contensou/integrate/schemes.hpp"

namespace contensou {

RunReport run_event_driven(const MechanicalSystem& system, State& state, double t_end,
                           const IntegratorOptions& options, const Observer& observer) {
  Dop853 step;
  return HybridRun(system, state, t_end, options, observer, step, StepChoice::adaptive).run();
}

}  // namespace contensou
