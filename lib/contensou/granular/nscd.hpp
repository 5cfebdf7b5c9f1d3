#pragma once

#include <cstddef>
#include <cstdint>

#include "contensou/integrate/motion.hpp"
#include "contensou/system/body_data.hpp"

namespace contensou {

/// What a run of nscd met, for reports of cost and trust.
struct NscdCounts {
  std::int64_t pairs_examined = 0;  ///< gaps computed, all steps together
  std::int64_t lists = 0;           ///< times the broad phase was made anew
  std::int64_t contacts = 0;        ///< contacts in the inclusions, all steps together
  std::size_t most_contacts = 0;    ///< of one step
  std::int64_t unsolved = 0;        ///< inclusions that did not reach solver_tolerance
  double deepest = 0;               ///< the deepest penetration at the start of a step [m] >= 0
};

/// Nonsmooth contact dynamics (Moreau and Jean) for many rigid bodies: time-stepping with fixed step Δt,
/// first order, contacts found anew in each step by a broad phase, one inclusion (4.7)–(4.9) a step for all
/// of them, solved on velocity level by block Gauss–Seidel with W never formed beyond the blocks of touching
/// pairs. Time a step and memory grow with bodies and contacts, not with their square.
///
/// A step, W and gaps at the middle q⁻ + ½Δt F u⁻, LG03 (4.5)–(4.9):
///     u_f = u⁻ + M⁻¹hΔt     with drag and loads exact for constant ones (body_motion.hpp), the gyroscopic
///                           term conserving energy (gyration.hpp);
///     u⁺ = u_f + M⁻¹WΛ,     γ⁺ = Wᵀu⁺ + w̃,
///     0 <= γ_N⁺ − c ⊥ Λ_N >= 0,    −γ_F⁺ ∈ N_B(μΛ_N)(Λ_F),
///     c = −g/Δt, so that no gap ends below zero; in an impact with restitution −ε_N γ_N⁻ (approach.hpp);
///     q⁺ = q⁻ + Δt F ū,     ū = ½(u⁻ + u⁺), or u⁺ for bodies that half of u⁻ would take into each other.
/// Gaps enter the law, not only its activation: what is in contact does not drift into each other, what
/// would collide within the step cannot pass, however fast, where the inclusion is solved: gaps of spheres
/// are convex, so their tangent is on the safe side (approach.hpp), and contacts that close only by the
/// impulses of others are added until there are none. A residual ρ may leave a gap of −ρΔt max |γ − c| (balls
/// shot at 1e6 m/s, 10⁵ radii a step, at others between them and a wall: 2e-5 and 2 cm). A contact that so
/// closes in the step of another's impact ends it touching and bounces in the next step with what is left of
/// its approach.
///
/// Free flight with constant forces is exact; else first order. E₁ = E₀ + work − Σ dissipated.total() + Σ
/// dissipated.driven to rounding, `dissipated` by rule (contact_account.hpp), `work` of drag, if any, then
/// of each load. A contact radius that follows the load takes that of the step before.
///
/// options.fidelity, if given: contacts with drilling friction and a constant radius whose slip before the
/// step has max(1 − ξ(u), η(u)) <= fidelity are solved as point contacts, and again in full where that does
/// not hold at the end; counted in left_out.
///
/// `state`: as BodyLayout(data) lays it out; moved on to t_end or as far as it comes. The observer is shown
/// samples as integrate() shows them, linear within a step, with no modes. The report has no events;
/// inclusions that are not solved to solver_tolerance (in at most 1000 sweeps) do not end the run: they are
/// counted, worst_residual says how bad, and `message` tells both. options: step, solver_tolerance,
/// output_interval, max_steps, fidelity. The result is the same to the last bit for any number of threads
/// >= 1.
///
/// Throws std::invalid_argument with one line for data, a state or options that make no sense, a start with
/// bodies in each other or in a plane (by more than 1e-6 of a radius and Δt²g) included.
RunReport run_nscd(const BodiesData& data, State& state, double t_end, const IntegratorOptions& options,
                   int threads, const Observer& observer = {}, NscdCounts* counts = nullptr);

}  // namespace contensou
