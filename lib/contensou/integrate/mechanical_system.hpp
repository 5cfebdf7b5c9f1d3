#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "contensou/contact/contact_problem.hpp"

namespace contensou {

using Vector = Eigen::VectorXd;
using ConstVector = const Eigen::Ref<const Eigen::VectorXd>&;
using VectorRef = Eigen::Ref<Eigen::VectorXd>;

/// A contact radius that follows the load by Hertz, LG03 (3.2): R(λ_N) = (3 ρ* λ_N / (4 E*))^{1/3}.
struct LoadRadius {
  double relative_radius = 0;  ///< ρ* [m] > 0
  double modulus = 0;          ///< E* [Pa] > 0

  /// R [m] under λ_N [N]; zero where λ_N <= 0.
  double at(double lambda_n) const;
  /// The largest load [N] of an elastic impact of the mass m* [kg] with the approach velocity v [m/s]; zero
  /// where v <= 0. By Hertz, F = K δ^{3/2} at an approach δ of the bodies, K = (4/3) E* √ρ*. All of the
  /// kinetic energy is in the contact where δ is largest,
  ///     ½ m* v² = ∫ F dδ = (2/5) K δ^{5/2},   so   F = K^{2/5} (5/4 m* v²)^{3/5}
  /// (K.L. Johnson, Contact Mechanics, 1985, Section 11.4; R = √(ρ*δ) there).
  double impact_load(double mass, double speed) const;
};

/// What a contact of a system is made of. The rows it has are those of its friction: 1, 3 or 4.
struct SystemContact {
  std::string name;
  AnyFriction friction;
  double mu = 0;           ///< friction coefficient, >= 0; unused where frictionless
  double radius = 0;       ///< contact radius R [m], > 0 with four rows; unused otherwise
  double restitution = 0;  ///< ε_N, 0 to 1
  /// Given: the contact radius follows the load, and `radius` is only what rows and scales are written in.
  /// Four rows, moreau, moreau_implicit and moreau_adaptive only (implicit_stage.hpp).
  std::optional<LoadRadius> load_radius = {};
};

/// Whether there is a radius and it follows the load.
bool follows_load(const SystemContact& contact);

/// The rows of one contact at one state, in the order (N, T1, T2, τ); columns beyond the contact's own are
/// left alone. f velocities.
struct ContactRows {
  Eigen::Matrix<double, Eigen::Dynamic, 4> directions;  ///< (w_N, w_T1, w_T2, w_τ), f × 4
  Eigen::Matrix<double, Eigen::Dynamic, 4> response;    ///< M⁻¹ of these, f × 4
  Eigen::Vector4d velocity;                             ///< γ = Wᵀu + w̃ [m/s], last one ωR
  Eigen::Vector4d drift;                                ///< γ̇ at u̇ = 0: Ẇᵀu + ∂w̃/∂t [m/s²]

  explicit ContactRows(Eigen::Index f = 0) : directions(f, 4), response(f, 4) {}

  /// w̃ of a row: what is left of γ without Wᵀu, u that of `velocity`.
  double given(int row, ConstVector u) const { return velocity[row] - directions.col(row).dot(u); }
};

/// A mechanical system with unilateral contacts, LG03 (4.1), as integrators see it:
///     M(q)u̇ = h(t, q, u) + Σ W_i(t, q) λ_i,     q̇ = F(q)u,     γ_i = W_iᵀu + w̃_i,     ġ_Ni = γ_Ni.
/// Coordinates q (n of them) and velocities u (f <= n; for f = n and F = 1 these are LG03's). A system is
/// immutable; its functions are pure, allocate nothing, and write into memory of the right size that they are
/// given (rows: ContactRows(f)).
class MechanicalSystem {
 public:
  virtual ~MechanicalSystem() = default;

  virtual Eigen::Index coordinates() const = 0;
  virtual Eigen::Index velocities() const = 0;
  /// Set at construction; the order is that of all contact indices.
  const std::vector<SystemContact>& contacts() const { return contacts_; }

  /// q̇ = F(q)u.
  virtual void coordinate_rates(ConstVector q, ConstVector u, VectorRef rates) const;
  /// Back onto the manifold of coordinates after a step (unit quaternions, unit axes); nothing to do for
  /// most.
  virtual void restore(VectorRef q) const;

  /// A length of the size of the motion [m]: rounding of gaps and the accuracy of coordinates are judged by
  /// it.
  virtual double length_scale() const { return 1; }
  /// What errors of the coordinates are measured by, n: length_scale() for lengths, 1 for angles and axes.
  /// All 1 where not overridden.
  virtual void coordinate_scales(VectorRef scales) const;

  /// M(q), f × f.
  virtual void mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const = 0;
  /// h(t, q, u), f.
  virtual void force(double t, ConstVector q, ConstVector u, VectorRef h) const = 0;
  /// M(q)⁻¹h(t, q, u), f: the acceleration without contacts. Where this is infinite or undefined (a singular
  /// M), so are the numbers written.
  virtual void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const = 0;

  /// g_N of a contact [m].
  virtual double gap(std::size_t contact, double t, ConstVector q) const = 0;
  /// All of ContactRows, also for an open contact.
  virtual void contact_rows(std::size_t contact, double t, ConstVector q, ConstVector u,
                            ContactRows& rows) const = 0;

  /// Whether w̃ of any contact may be other than zero: only then do integrators ask what it puts in.
  virtual bool driven() const { return false; }

  virtual double kinetic_energy(ConstVector q, ConstVector u) const = 0;  ///< [J]
  virtual double potential_energy(ConstVector q) const = 0;               ///< [J]

  /// Accounts of the energy that goes in and out beside potential energy and contacts, by name: what a load
  /// puts in, what the air takes. Empty, as it is where not overridden: powers() is never called.
  virtual const std::vector<std::string>& works() const;
  /// The power into the motion by each account [W].
  virtual void powers(double t, ConstVector q, ConstVector u, VectorRef power) const;

 protected:
  /// Throws std::invalid_argument with one line that names the contact and what is wrong with it.
  explicit MechanicalSystem(std::vector<SystemContact> contacts);

 private:
  std::vector<SystemContact> contacts_;
};

}  // namespace contensou
