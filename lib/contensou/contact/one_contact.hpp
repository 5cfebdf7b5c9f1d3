#pragma once

#include "contensou/contact/blocks.hpp"

namespace contensou {

/// How a contact ends.
enum class ContactState {
  open,      ///< Λ = 0
  stick,     ///< Λ_N > 0 and γ_F = 0 (or no friction rows)
  slip,      ///< Λ_N > 0, Λ_F on the border of B(μΛ_N)
  unsolved,  ///< no solution was found: on acceleration level there may be none (Painlevé's paradox)
};

template <class Domain>
struct OneContactSolution {
  ContactVector<Domain> impulse;
  ContactState state;
  int iterations;   ///< of the search for the slip direction; 0 in closed form
  double residual;  ///< the largest error of γ in the laws that hold in this state, relative to max |b|
};

/// Solves the contact problem (contact_problem.hpp) of one contact: γ = WΛ + b, 0 <= γ_N ⊥ Λ_N >= 0,
/// −γ_F ∈ N_B(μΛ_N)(Λ_F), with W = W_ii.
///
/// Where b_N >= 0, the contact opens: Λ = 0. Else Λ_N > 0, and γ_N = 0 gives it from Λ_F. The contact sticks
/// if the Λ_F that stops it is within B(μΛ_N). If not, Λ_F is on the border and γ_F along the inward normal
/// there: with γ_F = −σD(u)Λ_F, where the diagonal D(u) is that of the ellipsoid which touches the border
/// where the slip ratio is u, (A + σD)Λ_F = −b' is linear, and what remains are two equations, in σ and in u
/// (a disk has D = I and no u). Newton's method solves both at once, mostly in 4 or 5 steps, the first of
/// them on a border interpolated between stored points; where it does not converge, bracketed iterations
/// solve one in the other. For W symmetric and positive definite both have a solution, whatever μ; W may also
/// be singular, have entries of any size or be not symmetric, but then there need not be one.
///
/// Where sliding and drilling friction are apart (FrictionCylinder), spin is held or has one sign or the
/// other, and each leaves a contact of Coulomb's, at most three of them (cylinder_contact.hpp).
///
/// `guess`: Λ to start from; zero for none. The solution, where unique, does not depend on it. Where the
/// equations above leave a residual above 1e-13 (singular W, a fold in σ, W not positive), Newton's method on
/// the natural map (4.17) follows, then proximal point steps (a compliance of 4e-6 W_FF added and made good
/// for), and the best is returned. Bounded time, no memory allocated. All arguments finite, μ >= 0; not
/// checked.
template <class Domain>
OneContactSolution<Domain> solve_one_contact(const Domain& domain, double mu, const ContactMatrix<Domain>& w,
                                             const ContactVector<Domain>& b,
                                             const ContactVector<Domain>& guess);

template <>
OneContactSolution<NoFriction> solve_one_contact(const NoFriction&, double mu,
                                                 const ContactMatrix<NoFriction>& w,
                                                 const ContactVector<NoFriction>& b,
                                                 const ContactVector<NoFriction>& guess);

}  // namespace contensou
