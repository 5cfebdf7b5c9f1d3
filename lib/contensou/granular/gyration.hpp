#pragma once

#include <Eigen/Core>

namespace contensou {

/// Euler's equations Iω̇ = −ω × Iω over dt, in principal axes, by the implicit midpoint rule
///     I(ω₁ − ω₀) = −dt ω_m × Iω_m,    ω_m = (ω₀ + ω₁)/2,
/// which keeps the energy ½ω·Iω to rounding and is of second order; in as many substeps as keep the turn of
/// each below a quarter, at most 64 (with more spin than that it only stays bounded).
Eigen::Vector3d gyrated(const Eigen::Vector3d& inertia, const Eigen::Vector3d& omega, double dt);

}  // namespace contensou
