#pragma once

#include <Eigen/Core>
#include <functional>

#include "motions/free_rotation.hpp"

/// The thrown book of free_body.toml.
namespace verify::answers::book {

using Motion = known_motions::FreeRotation;

// The file's data.
inline const Eigen::Vector3d inertia(2.0e-3, 5.8e-3, 3.9e-3), omega(0.05, 0.02, 10);
inline constexpr double interval = 1e-2;

Motion thrown();
/// Of the third axis from where it was at the start [rad].
double tilt(const Motion& motion, double t);

using Whole = Eigen::Matrix<double, 12, 1>;
/// Spin in space, in units of the spin at the start, and the body's axes, one below the other.
Whole whole(const Motion& motion, double t);
/// How much `value` changes when the spin at the start does by 1 (relative, in each component, added up):
/// what an error of the steps made early becomes.
double spread(const std::function<Whole(const Motion&)>& value);

}  // namespace verify::answers::book
