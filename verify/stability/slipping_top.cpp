#include "slipping_top.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <variant>

#include "contensou/law/force.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"

namespace verify::stability {
namespace {

using Eigen::Vector3d;

contensou::AnyFriction four_rows() {
  return contensou::FrictionBall{contensou::SmoothPlate{contensou::HertzLaw{}}};
}

/// λ_F/λ_N.
Vector3d relative_friction(const Setting& s, const Vector3d& gamma) {
  const contensou::Load load{.mu = s.mu, .lambda_n = 1};
  const contensou::FrictionResponse response =
      s.pressure == Pressure::hertz ? contensou::friction_force(contensou::HertzLaw{}, load, gamma)
                                    : contensou::friction_force(contensou::UniformLaw{}, load, gamma);
  Vector3d force = std::get<contensou::FrictionForce>(response);  // throws at rest, where nothing slips
  if (!s.drilling) force[2] = 0;
  return force;
}

}  // namespace

const char* name(Pressure pressure) { return pressure == Pressure::hertz ? "hertz" : "uniform"; }

Setting paper_top(std::size_t contact) {
  Setting s;
  s.contact = contact;
  return s;
}

Setting top_of_shape(double h_over_r, double i3_over_i1) {
  Setting s;
  const double h = s.h();
  s.top.i3 = i3_over_i1 * s.top.i1;
  s.top.r1 = h / h_over_r;
  s.top.a1 = s.top.r1 - h;
  return s;
}

SlippingTop::SlippingTop(const Setting& setting)
    : setting_(setting),
      system_(setting.top, contensou::tippe_top_contacts(four_rows(), setting.mu, setting.radius)),
      rows_(6),
      acceleration_(6) {}

void SlippingTop::derivative(double t, const Eigen::VectorXd& y, Eigen::VectorXd& dy) {
  const auto q = y.head<6>();
  const auto u = y.tail<6>();
  dy.resize(12);
  system_.coordinate_rates(q, u, dy.head<6>());
  system_.free_acceleration(t, q, u, acceleration_);
  system_.contact_rows(setting_.contact, t, q, u, rows_);
  gamma_f_ = rows_.velocity.tail<3>();
  const Vector3d per_normal = relative_friction(setting_, gamma_f_);
  const Eigen::Matrix<double, 6, 1> response =
      rows_.response * Eigen::Vector4d(1, per_normal[0], per_normal[1], per_normal[2]);
  const auto normal = rows_.directions.col(0);
  lambda_n_ = -(rows_.drift[0] + normal.dot(acceleration_)) / normal.dot(response);
  lambda_f_ = lambda_n_ * per_normal;
  dy.tail<6>() = acceleration_ + lambda_n_ * response;
}

Eigen::VectorXd state(const Setting& s, double spin, const Deviation& d) {
  const double ca = std::cos(d.alpha), sa = std::sin(d.alpha);
  const double cb = std::cos(d.beta), sb = std::sin(d.beta);
  const Vector3d n(sb, -sa * cb, ca * cb);
  // α about the floor's first axis, β about the second axis turned by α, the rest about n.
  const Vector3d about = d.alpha_rate * Vector3d::UnitX() + d.beta_rate * Vector3d(0, ca, sa);
  const Vector3d omega = about + (spin - about.dot(n)) * n;
  Eigen::VectorXd y(12);
  y << 0, 0, s.r() - s.a() * n[2], s.up() * n, d.vx, d.vy, 0, omega;
  y[8] = -omega.cross(Vector3d(s.a() * n))[2];
  return y;
}

double inclination(const Setting& s, const Eigen::VectorXd& y) {
  return std::atan2(std::hypot(y[3], y[4]), s.up() * y[5]);
}

double spin(const Setting& s, const Eigen::VectorXd& y) { return s.up() * y.tail<3>().dot(y.segment<3>(3)); }

}  // namespace verify::stability
