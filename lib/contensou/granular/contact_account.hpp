#pragma once

#include <vector>

#include "contensou/granular/contact_set.hpp"

namespace contensou {

/// How each body moves in a step whose velocities are known: touched where an impulse acts on it; dragged
/// where the mean velocity of a touched contact's bodies would end the step with a gap below zero (u⁺ does
/// not). Dragging spreads from contact to contact until no gap asks for
/// more. `touch`: one for each body.
void decide_touch(ContactSet& set, const std::vector<Approach>& approach, const std::vector<Twist>& before,
                  const std::vector<Twist>& after, double dt, std::vector<BodyMotion::Touch>& touch);

/// Adds to `dissipated`, by rule, what the impulses took: −Λ·½(γ⁺ + γ⁻), in impacts (is_impact) all rows as
/// `impact`, else the normal row as `impact`, the others as `sliding` and `drilling`; and the `excess` of
/// dragged bodies, shared by their contacts as their normal impulses are, where the tangential rows went. So
///     E₁ = E₀ + work − Σ total + Σ driven
/// is an identity, to rounding.
void add_dissipation(const BodiesData& data, ContactSet& set, const std::vector<Approach>& approach,
                     const std::vector<Twist>& before, const std::vector<Twist>& after,
                     const std::vector<double>& excess, std::vector<double>& load,
                     std::vector<Dissipation>& dissipated);

}  // namespace contensou
