#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>

#include "contensou/contact/contact_problem.hpp"

namespace random_contact {

/// How the contacts hang together.
enum class Structure {
  tree,         ///< as many bodies as contacts, no loops: W positive definite (unless a contact radius is 0)
  loops,        ///< fewer bodies than contacts, normals in all directions: wedges, mostly rank-deficient
  support,      ///< all normals parallel (plates and stacks on a floor), one to as many bodies as contacts
  redundant,    ///< contacts twice over: rank-deficient, impulses not unique
  constrained,  ///< bodies with degrees of freedom taken away: even a single W_ii is singular
};
/// What the bodies do without contact impulses.
enum class Motion {
  impact,    ///< approaching and sliding alike
  sliding,   ///< sliding fast, approaching slowly, 1e-6 to 1e-2 of it
  sticking,  ///< within 1e-12 to 1e-1 of the border between sticking and slipping, on either side
  opening,   ///< most contacts open
  grazing,   ///< b_N = 0, to rounding, in most contacts
  resting,   ///< under their own weight, with a little drift
};
/// The rows of the contacts.
enum class Rows { frictionless, coulomb, contensou, mixed };
/// The largest friction coefficient.
enum class Roughness { zero, small, medium, large };  ///< 0, up to 0.1, up to 1, up to 10

constexpr std::array<std::string_view, 5> structures{"tree", "loops", "support", "redundant", "constrained"};
constexpr std::array<std::string_view, 6> motions{"impact",  "sliding", "sticking",
                                                  "opening", "grazing", "resting"};
constexpr std::array<std::string_view, 4> row_kinds{"frictionless", "coulomb", "contensou", "mixed"};
constexpr std::array<std::string_view, 4> roughnesses{"zero", "up to 0.1", "up to 1", "up to 10"};

struct RandomProblem {
  contensou::ContactProblem problem;
  Structure structure;
  Motion motion;
  Rows rows;
  Roughness roughness;
};

/// Random contact problem number `seed`: 1 to 8 contacts between bodies of mass ratio up to 1e6, W = HᵀM⁻¹H.
/// μ is 0 or logarithmically uniform to 10, contact radii 0 or 1e-9 to 1e2 of the body; pressures uniform,
/// Hertz, (1 − ρ²/R²)², or the ellipsoid. The same on every machine but for rounding.
///
/// Each has a solution, for any μ: there are velocities of the bodies that open every contact without
/// sliding, the criterion of Acary, Cadoux, Lemaréchal & Malick (ZAMM 91, 2011, 155–175) and, as "no
/// admissible self-stress works", of Klarbring & Pang (SIAM J. Optim. 8, 1998, 341–360). Their proofs need of
/// the friction cone that it is convex, so they hold for the friction ball as for the disk. b = Hᵀu + s with
/// s_F = 0 and s_N >= 0 (a gap still to be closed): the bodies' velocities −u leave γ = s. In `support` s_N
/// has any sign (Newton's restitution brings ε γ_N⁻): lifting every body off the one below opens all
/// contacts, whatever b. Where s_N = 0 the criterion holds on its border; that is enough but for sets of
/// measure zero (self-stresses on the very border of the cone).
RandomProblem random_problem(std::uint64_t seed);

}  // namespace random_contact
