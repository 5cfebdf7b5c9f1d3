#include "top_oracle.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace verify::ledger::top {

State generic() {
  State s;
  s.q << 0.3, -0.2, 1.4, 0.7, 0.4, -1.1;
  s.u << 0.5, -0.8, 0.3, 1.3, -0.9, 2.1;
  return s;
}

Matrix3d turn(double angle, int i, int j) {
  Matrix3d t = Matrix3d::Identity();
  t(i, i) = t(j, j) = std::cos(angle);
  t(i, j) = std::sin(angle);
  t(j, i) = -std::sin(angle);
  return t;
}

Matrix3d attitude(const Vector6& q) {
  return (turn(q[5], 0, 1) * turn(q[3], 1, 2) * turn(q[4], 0, 1)).transpose();
}

Vector3d spin(const State& s) {
  const Matrix3d w =
      rate([](const State& x) { return attitude(x.q); }, s, Vector6::Zero()) * attitude(s.q).transpose();
  return {w(2, 1), w(0, 2), w(1, 0)};
}

Vector3d arm(int i, const Vector6& q) { return attitude(q).col(2) * a[i] - Vector3d(0, 0, r[i]); }

Eigen::Vector4d contact_velocity(int i, const State& s) {
  const Vector3d omega = spin(s);
  const Vector3d v = s.u.head<3>() + omega.cross(arm(i, s.q));
  return {v[2], v[0], v[1], radius * omega[2]};
}

Matrix6 mass(double theta) {
  const double s = std::sin(theta);
  const double c = std::cos(theta);
  Matrix6 result = Matrix6::Zero();
  result.diagonal() << m, m, m, i1, i1 * s * s + i3 * c * c, i3;
  result(4, 5) = result(5, 4) = i3 * c;
  return result;
}

Vector6 smooth(const State& x) {
  const double s = std::sin(x.q[3]);
  const double c = std::cos(x.q[3]);
  const double theta = x.u[3];
  const double phi = x.u[4];
  const double psi = x.u[5];
  return Vector6{{0, 0, -m * g, ((i1 - i3) * phi * c - i3 * psi) * phi * s,
                  (2 * (i3 - i1) * phi * c + i3 * psi) * theta * s, i3 * phi * theta * s}};
}

Eigen::Matrix<double, 6, 4> directions(int i, const Vector6& q) {
  const double s = std::sin(q[3]);
  const double c = std::cos(q[3]);
  const double sf = std::sin(q[4]);
  const double cf = std::cos(q[4]);
  const double h = a[i] * c - r[i];
  Eigen::Matrix<double, 6, 4> w;
  w << 0, 1, 0, 0,                              //
      0, 0, 1, 0,                               //
      1, 0, 0, 0,                               //
      -a[i] * s, h * sf, -h * cf, 0,            //
      0, a[i] * s * cf, a[i] * s * sf, radius,  //
      0, r[i] * s * cf, r[i] * s * sf, radius * c;
  return w;
}

Vector6 response(double theta, const Vector6& force) { return mass(theta).ldlt().solve(force); }

Vector6 acceleration(const State& s, const Vector6& force) { return response(s.q[3], smooth(s) + force); }

State flown(const State& start, double time, int steps) {
  const double h = time / steps;
  State s = start;
  const auto slope = [](const State& x) { return State{x.u, acceleration(x)}; };
  const auto moved = [](const State& x, double t, const State& k) {
    return State{x.q + t * k.q, x.u + t * k.u};
  };
  for (int i = 0; i < steps; ++i) {
    const State k1 = slope(s);
    const State k2 = slope(moved(s, h / 2, k1));
    const State k3 = slope(moved(s, h / 2, k2));
    const State k4 = slope(moved(s, h, k3));
    s.q += h / 6 * (k1.q + 2 * k2.q + 2 * k3.q + k4.q);
    s.u += h / 6 * (k1.u + 2 * k2.u + 2 * k3.u + k4.u);
  }
  return s;
}

}  // namespace verify::ledger::top
