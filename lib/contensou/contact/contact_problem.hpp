#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <variant>
#include <vector>

#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/friction_cylinder.hpp"
#include "contensou/ball/friction_disk.hpp"
#include "contensou/ball/smooth_plate.hpp"

namespace contensou {

/// What friction a contact has, and with it its number of rows, 1 + dimension: 1 (frictionless), 3 (point
/// contact with Coulomb friction), 4 (Coulomb–Contensou, or sliding and drilling friction apart). Visited
/// once for a group of contacts, never for each.
using AnyFriction = std::variant<NoFriction, FrictionDisk, FrictionBall<SmoothPlate<UniformLaw>>,
                                 FrictionBall<SmoothPlate<HertzLaw>>, FrictionBall<SmoothPlate<CompiledLaw>>,
                                 FrictionBall<SmoothPlate<EllipsoidLaw>>, FrictionCylinder>;

/// The number of rows of a contact with this friction: 1, 3 or 4.
int rows(const AnyFriction& friction);

/// Contacts that share one kind of friction.
struct ContactGroup {
  const AnyFriction* friction;  ///< outlives the problem; not null
  std::vector<double> mu;       ///< friction coefficient of each contact, >= 0; any number where frictionless
};

/// The algebraic inclusion of one time-step, LG03 (4.7)–(4.9), with the velocities eliminated (Delassus
/// form): find Λ with
///     γ = W Λ + b,    0 <= γ_N ⊥ Λ_N >= 0,    −γ_F ∈ N_B(μΛ_N)(Λ_F)      for each contact,
/// where the domain B(μΛ_N) of friction grows with the normal impulse that is solved for. Rows stand group by
/// group, contact by contact, in the order (N, T1, T2, τ) as far as the contact has them; the last one is
/// Λ_τ = (impulsive torque)/R against γ_τ = ωR, LG03 (2.17).
///
/// The same inclusion on acceleration level has accelerations in place of velocities and forces in place of
/// impulses (acceleration_level.hpp).
struct ContactProblem {
  std::vector<ContactGroup> groups;
  /// W = W_allᵀ M⁻¹ W_all [1/kg], positive semi-definite; symmetric on velocity level.
  Eigen::MatrixXd delassus;
  /// b [m/s]: γ for Λ = 0; in normal rows γ_N⁺ + ε_N γ_N⁻, see impact_law.hpp.
  Eigen::VectorXd free_velocity;

  std::size_t contacts() const;
  Eigen::Index rows() const;
};

/// Checks that each group has its friction, and the friction coefficients; throws std::invalid_argument with
/// one line that says which is wrong.
void require_valid_groups(const ContactProblem& problem);
/// The same, and sizes and finiteness.
void require_valid(const ContactProblem& problem);

/// The natural map's residual: how far Λ is from being a solution, as a velocity, relative to the problem's
/// largest:
///     max over contacts of  ‖Λ_i − Π_i(Λ_i − r_i γ_i)‖ / (r_i V),     r_i = 1/‖W_ii‖, V = max |b|,
/// where ‖W_ii‖ is the largest sum of |entries| in a row of the contact's own block, and Π_i projects the
/// normal impulse on R+ and then the friction on B(μΠ_N), LG03 (4.16), footnote 1. But for rounding, zero
/// only at solutions; for b = 0 it is zero there and infinite elsewhere. A contact whose W_ii is zero has
/// r_i = 1/(largest ‖W_jj‖), or 1 kg. Infinite where Λ or γ is not finite. Where impulses are so large that
/// their own rounding, 2^-52 ‖Λ_i‖/(r_i V), exceeds 1e-6, at least that, at solutions, too (not for b = 0).
double natural_map_residual(const ContactProblem& problem, const Eigen::VectorXd& impulse);

}  // namespace contensou
