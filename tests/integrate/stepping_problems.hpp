// Motions whose outcome is known, for the tests of the time-stepping schemes: from closed forms, or from
// DOP853 with the contact forces of sliding put in by hand (no contact solver, no time-stepping).
#pragma once

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "../system/tippe_top_states.hpp"
#include "contensou/integrate/dop853.hpp"
#include "contensou/integrate/motion.hpp"
#include "contensou/system/tippe_top_axis.hpp"

namespace stepping_problems {

using contensou::ConstVector;
using contensou::ContactMode;
using contensou::IntegratorOptions;
using contensou::Method;
using contensou::State;
using contensou::VectorRef;

/// A body that cannot tilt, over the floor z = 0: q = (x, y, z, ψ), u = q̇, mass 2 kg, moment of inertia 0.5
/// kg m², gravity 10 m/s², and a push on it. Its contact `floor` has the rows of its friction.
class Slab : public contensou::MechanicalSystem {
 public:
  static constexpr double m = 2, j = 0.5, g = 10;
  /// (F_x, F_y, F_z, torque) at time t.
  using Push = std::function<Eigen::Vector4d(double t)>;

  explicit Slab(contensou::SystemContact floor, Push push = {})
      : MechanicalSystem({floor}), rows_(contensou::rows(floor.friction)), push_(std::move(push)) {}

  Eigen::Index coordinates() const override { return 4; }
  Eigen::Index velocities() const override { return 4; }
  void mass_matrix(ConstVector, Eigen::Ref<Eigen::MatrixXd> mass) const override {
    mass.setZero();
    mass.diagonal() << m, m, m, j;
  }
  void force(double t, ConstVector, ConstVector, VectorRef h) const override {
    h << 0, 0, -m * g, 0;
    if (push_) h += push_(t);
  }
  void free_acceleration(double t, ConstVector q, ConstVector u, VectorRef a) const override {
    force(t, q, u, a);
    a.array() /= Eigen::Array4d(m, m, m, j);
  }
  double gap(std::size_t, double, ConstVector q) const override { return q[2]; }
  void contact_rows(std::size_t, double, ConstVector, ConstVector u,
                    contensou::ContactRows& rows) const override {
    rows.directions.setZero();
    rows.response.setZero();
    const double radius = contacts()[0].radius;
    const auto column = [&](Eigen::Index c, Eigen::Index axis, double arm, double inertia) {
      rows.directions(axis, c) = arm;
      rows.response(axis, c) = arm / inertia;
      rows.velocity[c] = arm * u[axis];
      rows.drift[c] = 0;
    };
    column(0, 2, 1, m);
    if (rows_ > 1) {
      column(1, 0, 1, m);
      column(2, 1, 1, m);
    }
    if (rows_ > 3) column(3, 3, radius, j);
  }
  double kinetic_energy(ConstVector, ConstVector u) const override {
    return (m * u.head<3>().squaredNorm() + j * u[3] * u[3]) / 2;
  }
  double potential_energy(ConstVector q) const override { return m * g * q[2]; }

  static State at(double z, Eigen::Vector4d u) { return {0, Eigen::Vector4d(0, 0, z, 0), u}; }

 private:
  int rows_;
  Push push_;
};

/// The motion of a system between events, by DOP853 with equal steps: free, or with one contact that slips
/// all the time, its λ_N from γ̇_N = 0 and λ_F = −μλ_N·border(γ_F).
class SmoothReference final : public contensou::OdeSystem {
 public:
  using Border = std::function<Eigen::Vector3d(const Eigen::Vector3d& gamma)>;  ///< of the unit friction ball

  SmoothReference(const contensou::MechanicalSystem& system, int contact, Border border = {})
      : system_(system), contact_(contact), border_(std::move(border)), rows_(system.velocities()) {}

  Eigen::Index size() const override { return system_.coordinates() + system_.velocities(); }
  void derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) override {
    const Eigen::VectorXd q = y.head(system_.coordinates()), u = y.tail(system_.velocities());
    Eigen::VectorXd rates(q.size()), a(u.size());
    system_.coordinate_rates(q, u, rates);
    system_.free_acceleration(t, q, u, a);
    if (contact_ >= 0) {
      const auto i = static_cast<std::size_t>(contact_);
      system_.contact_rows(i, t, q, u, rows_);
      if (!border_) {
        const auto w = rows_.directions.leftCols<3>();
        const Eigen::Vector3d left = w.transpose() * a + rows_.drift.head<3>();
        lambda_ = -Eigen::Matrix3d(w.transpose() * rows_.response.leftCols<3>()).ldlt().solve(left);
        dy << rates, a + rows_.response.leftCols<3>() * lambda_;
        return;
      }
      const Eigen::Vector3d friction = -system_.contacts()[i].mu * border_(rows_.velocity.tail<3>());
      const Eigen::VectorXd per_newton = rows_.response.col(0) + rows_.response.rightCols(3) * friction;
      const auto normal = rows_.directions.col(0);
      const double lambda = -(normal.dot(a) + rows_.drift[0]) / normal.dot(per_newton);
      a += lambda * per_newton;
    }
    dy << rates, a;
  }

  /// (λ_N, λ_T1, λ_T2) of the last evaluation in rolling.
  const Eigen::Vector3d& rolling_force() const { return lambda_; }

  State run(const State& start, double t_end, int steps) {
    Eigen::VectorXd y(size()), rate(size());
    y << start.q, start.u;
    contensou::Dop853 method;
    const double h = (t_end - start.t) / steps;
    derivative(start.t, y, rate);
    for (int k = 0; k < steps; ++k) {
      method.attempt(*this, start.t + k * h, y, rate, h, Eigen::VectorXd::Ones(size()));
      y = method.end();
      rate = method.end_rate();
    }
    return {t_end, y.head(system_.coordinates()), y.tail(system_.velocities())};
  }

 private:
  const contensou::MechanicalSystem& system_;
  int contact_;
  Border border_;
  contensou::ContactRows rows_;
  Eigen::Vector3d lambda_{0, 0, 0};
};

/// The paper's top with Hertz's pressure.
inline contensou::TippeTopAxis paper_top() {
  return {contensou::TippeTopData{}, contensou::tippe_top_contacts(system_test::hertz)};
}

/// Border point of the unit Hertz friction ball with the normal γ, from the law's force.
inline Eigen::Vector3d hertz_border(const Eigen::Vector3d& gamma) {
  return -std::get<contensou::FrictionForce>(contensou::friction_force(contensou::HertzLaw{}, {1, 1}, gamma));
}

/// In the air, turning about all axes, for 0.05 s.
inline State top_in_flight(const contensou::TippeTopAxis& top) {
  State s = top.start(0.7, 180, 0.1);
  s.u.tail<3>() += Eigen::Vector3d(20, -10, 5);
  s.u.head<3>() << 0.1, 0.2, 0.3;
  return s;
}
constexpr double flight_time = 0.05;
/// The paper's start; the body slips all the time up to here and beyond.
constexpr double slip_time = 0.02;

/// The paper's top as a point contact that cannot slip, rolling with its body in a generic manner.
inline contensou::TippeTopAxis rolling_top() {
  return {contensou::TippeTopData{}, contensou::tippe_top_contacts(system_test::point, 5)};
}
inline State top_rolling(const contensou::TippeTopAxis& top) {
  State s = top.start(0.7, 30);
  s.u.tail<3>() += Eigen::Vector3d(3, 0, 2);
  contensou::ContactRows rows(6);
  top.contact_rows(0, 0, s.q, s.u, rows);
  s.u[0] -= rows.velocity[1];
  s.u[1] -= rows.velocity[2];
  s.u[2] -= rows.velocity[0];
  return s;
}
constexpr double rolling_time = 0.1;

/// Largest of the errors of the coordinates and, per 100/s of the coordinates' scales, of the velocities.
inline double difference(const contensou::MechanicalSystem& system, const State& a, const State& b) {
  Eigen::VectorXd scale(a.q.size());
  system.coordinate_scales(scale);
  const double length = system.length_scale();
  Eigen::VectorXd speed = Eigen::VectorXd::Constant(a.u.size(), 100);
  speed.head<3>() *= length;
  return std::max((a.q - b.q).cwiseQuotient(scale).lpNorm<Eigen::Infinity>(),
                  (a.u - b.u).cwiseQuotient(speed).lpNorm<Eigen::Infinity>());
}

/// Where the motion ends with a fixed step.
inline State end_of(const contensou::MechanicalSystem& system, const State& start, double t_end,
                    Method method, double step, contensou::RunReport* report = nullptr,
                    IntegratorOptions options = {}) {
  options.method = method;
  options.step = step;
  State state = start;
  contensou::RunReport r = integrate(system, state, t_end, options);
  if (report) *report = std::move(r);
  return state;
}

}  // namespace stepping_problems
