#pragma once

#include <cstddef>
#include <cstdint>

#include "contensou/integrate/motion.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// What a run of nscd met, for reports of cost.
struct NscdCounts {
  std::int64_t pairs_examined = 0;  ///< gaps computed, all steps together
  std::int64_t contacts = 0;        ///< contacts in the inclusions, all steps together
  std::size_t most_contacts = 0;    ///< of one step
};

/// Nonsmooth contact dynamics (Moreau and Jean) for many rigid bodies: time-stepping with fixed step Δt,
/// first order, contacts found anew in each step by a broad phase, one inclusion (4.7)–(4.9) a step for all
/// of them, solved on velocity level by block Gauss–Seidel with W never formed beyond the blocks of touching
/// pairs. Time a step and memory grow with bodies and contacts, not with their square.
///
/// `state`: as BodyLayout(data) lays it out; moved on to t_end or as far as it comes. The observer is shown
/// samples as integrate() shows them, with no modes. The report's `dissipated` is by rule (data.rules), it
/// has no events. options: step, solver_tolerance, output_interval, max_steps, fidelity. The result is the
/// same to the last bit for any number of threads >= 1.
///
/// Throws std::invalid_argument with one line for data, a state or options that make no sense, a start with
/// bodies in each other or in a plane included.
RunReport run_nscd(const BodiesData& data, State& state, double t_end, const IntegratorOptions& options,
                   int threads, const Observer& observer = {}, NscdCounts* counts = nullptr);

}  // namespace contensou
