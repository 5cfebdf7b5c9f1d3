#pragma once

#include <functional>

#include "contensou/contact/contact_problem.hpp"
#include "contensou/law/friction_law.hpp"

/// Friction that is not the exact law's, as the integrators of the library take it.
namespace verify::story {

/// A law of u = v/s alone, asked at (u, 1) for u <= 1 and at (1, 1/u) for u >= 1.
struct HomogeneousLaw {
  std::function<contensou::Friction(double v, double s)> friction;
  std::function<double(double v, double s)> slope;  ///< of ξ(u): dξ/du where s = 1, u³ dξ/du where v = 1
};
/// As a friction ball whose borders and normals are what the law says they are, whether or not that is so of
/// any convex set: in slip it is the law, and the projection is the point from which the law's velocity leads
/// to the force projected.
contensou::AnyFriction compiled(const HomogeneousLaw& law);

/// With the semi-axes of Hertz.
contensou::AnyFriction ellipsoid();
/// True paraboloid, n = 1.
contensou::AnyFriction paraboloid();
/// What an iteration finds that projects on the exact ball along rays, not to the nearest point: the force on
/// its border against the velocity (γ_T, γ_τ) itself, λ_F ∥ −γ_F.
contensou::AnyFriction radial_hertz();
contensou::AnyFriction radial_uniform();
/// Hertz with λ_τ a millionth: drilling torque off, the coupling of λ_T to the spin left.
contensou::AnyFriction without_drilling();
/// The coefficient 3/(8π) of (5.24) in place of 3π/8 at small slip: Hertz at u/π².
contensou::AnyFriction misprinted_slope();

}  // namespace verify::story
