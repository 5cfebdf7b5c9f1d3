#include "contensou/integrate/slip_friction.hpp"

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace contensou {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// What a kind of friction does, on a variant that is known to hold it.
template <class Domain>
struct Kind;

template <>
struct Kind<NoFriction> {
  static Vector3d border(const AnyFriction&, const Vector3d&) { return Vector3d::Zero(); }
  static Matrix3d derivative(const AnyFriction&, const Vector3d&) { return Matrix3d::Zero(); }
  static double gauge(const AnyFriction&, const Vector3d&) { return 0; }
  static Vector3d normal(const AnyFriction&, const Vector3d&) { return Vector3d::Zero(); }
};

template <>
struct Kind<FrictionDisk> {
  static Vector3d border(const AnyFriction&, const Vector3d& gamma) {
    const double v = std::sqrt(gamma[0] * gamma[0] + gamma[1] * gamma[1]);
    return {gamma[0] / v, gamma[1] / v, 0};
  }
  static Matrix3d derivative(const AnyFriction& friction, const Vector3d& gamma) {
    const Vector3d n = border(friction, gamma);
    Matrix3d d = Matrix3d::Zero();
    d.topLeftCorner<2, 2>() =
        (Eigen::Matrix2d::Identity() - n.head<2>() * n.head<2>().transpose()) / gamma.head<2>().norm();
    return d;
  }
  static double gauge(const AnyFriction& friction, const Vector3d& force) {
    return std::get<FrictionDisk>(friction).gauge(force.head<2>());
  }
  static Vector3d normal(const AnyFriction&, const Vector3d& force) {
    Vector3d n = Vector3d::Zero();
    n.head<2>() = force.head<2>().stableNormalized();
    return n;
  }
};

template <class Plate>
struct Kind<FrictionBall<Plate>> {
  using Ball = FrictionBall<Plate>;

  static Vector3d border(const AnyFriction& friction, const Vector3d& gamma) {
    const double v = std::sqrt(gamma[0] * gamma[0] + gamma[1] * gamma[1]);
    const double s = std::abs(gamma[2]);
    // At rest there is no such point: not a number, for whoever tried the step to reject.
    if (!(v + s > 0 && std::isfinite(v + s))) return Vector3d::Constant(std::nan(""));
    const Friction x = std::get<Ball>(friction).plate().law().at(v, s);
    const double along = v > 0 ? x.xi / v : 0;
    return {along * gamma[0], along * gamma[1], std::copysign(x.eta, gamma[2])};
  }
  static Matrix3d derivative(const AnyFriction& friction, const Vector3d& gamma) {
    return hessian(std::get<Ball>(friction).plate().law(), Load{.mu = 1, .lambda_n = 1}, gamma);
  }
  static double gauge(const AnyFriction& friction, const Vector3d& force) {
    return std::get<Ball>(friction).gauge(force);
  }
  static Vector3d normal(const AnyFriction& friction, const Vector3d& force) {
    return std::get<Ball>(friction).normal(force);
  }
};

}  // namespace

SlipFriction::SlipFriction(const AnyFriction& friction) : friction_(&friction) {
  std::visit(
      [this]<class Domain>(const Domain&) {
        if constexpr (std::is_same_v<Domain, FrictionCylinder>) {
          throw std::invalid_argument(
              "slip friction: sliding and drilling friction apart have a border with edges, expected "
              "friction "
              "with a smooth one");
        } else {
          dimension_ = Domain::dimension;
          border_ = Kind<Domain>::border;
          derivative_ = Kind<Domain>::derivative;
          gauge_ = Kind<Domain>::gauge;
          normal_ = Kind<Domain>::normal;
        }
      },
      friction);
}

}  // namespace contensou
