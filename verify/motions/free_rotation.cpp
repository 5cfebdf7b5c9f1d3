#include "motions/free_rotation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

namespace known_motions {

using Eigen::Matrix3d;
using Eigen::Vector3d;

FreeRotation::FreeRotation(const Vector3d& inertia, const Vector3d& omega)
    : inertia_(inertia), start_(omega), twice_energy_(inertia.dot(omega.cwiseAbs2())), axis_{0, 1, 2} {
  std::sort(axis_.begin(), axis_.end(), [&](int i, int j) { return inertia[i] < inertia[j]; });
  const double square = inertia.cwiseProduct(omega).squaredNorm();  // L²
  if (square < twice_energy_ * inertia[axis_[1]]) std::swap(axis_[0], axis_[2]);
  const auto [a, b, c] = axis_;
  const double ia = inertia[a], ib = inertia[b], ic = inertia[c];
  const double from_c = twice_energy_ * ic - square;  // these two and the differences of moments have the
  const double from_a = square - twice_energy_ * ia;  // same sign, whichever end c is
  amplitude_ << std::sqrt(from_c / (ia * (ic - ia))), std::sqrt(from_c / (ib * (ic - ib))),
      std::copysign(std::sqrt(from_a / (ic * (ic - ia))), omega[c]);
  modulus_ = std::sqrt((ib - ia) * from_c / ((ic - ib) * from_a));
  // I_b ω̇_b = ±(I_c − I_a) ω_c ω_a: which way round
  const double handed = (b - a + 3) % 3 == 1 ? 1 : -1;
  rate_ = std::copysign(std::sqrt((ic - ib) * from_a / (ia * ib * ic)), handed * (ic - ia) * omega[c]);
  phase_ = boost::math::ellint_1(modulus_, std::atan2(omega[b] / amplitude_[1], omega[a] / amplitude_[0]));
}

Vector3d FreeRotation::omega(double t) const {
  double cn = 0;
  double dn = 0;
  const double sn = boost::math::jacobi_elliptic(modulus_, phase_ + rate_ * t, &cn, &dn);
  Vector3d result;
  result[axis_[0]] = amplitude_[0] * cn;
  result[axis_[1]] = amplitude_[1] * sn;
  result[axis_[2]] = amplitude_[2] * dn;
  return result;
}

Matrix3d FreeRotation::frame(const Vector3d& angular_momentum) const {
  Matrix3d result;
  result.col(0) = angular_momentum.normalized();
  result.col(1) = result.col(0).cross(Vector3d::Unit(axis_[2])).normalized();
  result.col(2) = result.col(0).cross(result.col(1));
  return result;
}

Matrix3d FreeRotation::attitude(double t) const {
  const Vector3d momentum = inertia_.cwiseProduct(start_);
  const double square = momentum.squaredNorm();
  const auto turning = [&](double time) {
    const double w = omega(time)[axis_[2]];
    const double ic = inertia_[axis_[2]];
    return std::sqrt(square) * (twice_energy_ - ic * w * w) / (square - ic * ic * w * w);
  };
  constexpr unsigned depth = 15;
  constexpr double tolerance = 1e-14;
  const double angle =
      boost::math::quadrature::gauss_kronrod<double, 31>::integrate(turning, 0.0, t, depth, tolerance);
  return Eigen::AngleAxisd(angle, momentum.normalized()) * frame(momentum) *
         frame(inertia_.cwiseProduct(omega(t))).transpose();
}

SymmetricRotation::SymmetricRotation(double across, double along, const Vector3d& omega)
    : start_(omega),
      precession_(omega[0], omega[1], along / across * omega[2]),
      spin_((1 - along / across) * omega[2]) {}

Vector3d SymmetricRotation::omega(double t) const {
  return Eigen::AngleAxisd(-spin_ * t, Vector3d::UnitZ()) * start_;
}

Matrix3d SymmetricRotation::attitude(double t) const {
  return (Eigen::AngleAxisd(precession_.norm() * t, precession_.normalized()) *
          Eigen::AngleAxisd(spin_ * t, Vector3d::UnitZ()))
      .toRotationMatrix();
}

}  // namespace known_motions
