#include "contensou/integrate/classic_rk4.hpp"
#include "contensou/integrate/hybrid_run.hpp"
#include "contensou/integrate/schemes.hpp"

namespace contensou {

RunReport run_rk4(const MechanicalSystem& system, State& state, double t_end,
                  const IntegratorOptions& options, const Observer& observer) {
  ClassicRk4 step;
  return HybridRun(system, state, t_end, options, observer, step, StepChoice::fixed).run();
}

}  // namespace contensou
