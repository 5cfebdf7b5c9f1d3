#pragma once

#include <Eigen/Core>

/// The tippe-top of LG03 Section 5 for the rows of Sections 4 and 5: its data, its attitude and the motion of
/// its points by differences of that, and beside it the paper's terms as printed. None of it comes from the
/// library.
namespace verify::ledger::top {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Eigen::Matrix3d;
using Eigen::Vector3d;

/// LG03 5.4, in units of 1e-2 m, 1e-3 kg, s, so that all numbers are of order one. Index 0 is the body, 1 the
/// tip.
inline constexpr double m = 6, i1 = 8, i3 = 7, g = 981;
inline constexpr double a[] = {0.3, 1.6};
inline constexpr double r[] = {1.5, 0.5};
inline constexpr double radius = 0.05;

struct State {
  Vector6 q;
  Vector6 u;
};

/// A state in which nothing is zero.
State generic();

/// The cosine matrix of a turn of the frame in the plane of axes i and j.
Matrix3d turn(double angle, int i, int j);
/// Body to floor, A^{14}, from (5.1).
Matrix3d attitude(const Vector6& q);

/// Five-point derivative along q(t) = q + ut + at²/2: h⁴ and 1e-16/h.
template <class F>
auto rate(const F& f, const State& s, const Vector6& acceleration) {
  constexpr double h = 2e-3;
  const auto at = [&](double t) {
    return f(State{s.q + t * s.u + t * t / 2 * acceleration, s.u + t * acceleration}).eval();
  };
  return ((8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h)).eval();
}
inline constexpr double differences = 1e-7;

/// Angular velocity in the floor's axes, from the attitude alone.
Vector3d spin(const State& s);
/// From the centre of mass to the contact point.
Vector3d arm(int i, const Vector6& q);
/// Velocity of the body's material point at the contact, and ω_3R: (N, T1, T2, τ).
Eigen::Vector4d contact_velocity(int i, const State& s);

/// M and h as printed, (5.9).
Matrix6 mass(double theta);
Vector6 smooth(const State& s);
/// (W_N, W_T, W_τ), as printed, (5.16), (5.20), (5.21).
Eigen::Matrix<double, 6, 4> directions(int i, const Vector6& q);

/// M⁻¹(h + force) by a factorisation.
Vector6 acceleration(const State& s, const Vector6& force = Vector6::Zero());
/// M⁻¹ force at that inclination.
Vector6 response(double theta, const Vector6& force);
/// The top in free flight, by Runge and Kutta in that many steps.
State flown(const State& start, double time, int steps);

}  // namespace verify::ledger::top
