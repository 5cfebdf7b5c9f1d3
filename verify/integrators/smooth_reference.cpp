#include "smooth_reference.hpp"

#include <Eigen/Cholesky>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <vector>

#include "contensou/law/force.hpp"
#include "contensou/law/hertz.hpp"

namespace verify::integrators {
namespace {

using contensou::ContactRows;
using contensou::MechanicalSystem;
using Eigen::VectorXd;
using Numbers = std::vector<double>;

/// Adds to the acceleration what the contact does to it.
void add_slip(const contensou::SystemContact& contact, const ContactRows& rows, VectorXd& a) {
  const auto friction = std::get<contensou::FrictionForce>(
      contensou::friction_force(contensou::HertzLaw{}, {contact.mu, 1}, rows.velocity.tail<3>()));
  const VectorXd per_newton = rows.response.col(0) + rows.response.rightCols<3>() * friction;
  const auto normal = rows.directions.col(0);
  a -= (normal.dot(a) + rows.drift[0]) / normal.dot(per_newton) * per_newton;
}

void add_rolling(const ContactRows& rows, VectorXd& a) {
  const auto w = rows.directions.leftCols<3>();
  const Eigen::Matrix3d delassus = w.transpose() * rows.response.leftCols<3>();
  const Eigen::Vector3d left = w.transpose() * a + rows.drift.head<3>();
  a -= rows.response.leftCols<3>() * delassus.ldlt().solve(left);
}

}  // namespace

contensou::State smooth_reference(const MechanicalSystem& system, Kept kept, const contensou::State& start,
                                  double t_end, int steps) {
  const Eigen::Index n = system.coordinates(), f = system.velocities();
  ContactRows rows(f);
  VectorXd rates(n), a(f);
  const auto derivative = [&](const Numbers& y, Numbers& dy, double t) {
    const VectorXd q = Eigen::Map<const VectorXd>(y.data(), n),
                   u = Eigen::Map<const VectorXd>(y.data() + n, f);
    system.coordinate_rates(q, u, rates);
    system.free_acceleration(t, q, u, a);
    system.contact_rows(0, t, q, u, rows);
    if (kept == Kept::slip) add_slip(system.contacts()[0], rows, a);
    if (kept == Kept::roll) add_rolling(rows, a);
    dy.resize(y.size());
    Eigen::Map<VectorXd>(dy.data(), n) = rates;
    Eigen::Map<VectorXd>(dy.data() + n, f) = a;
  };
  Numbers y(static_cast<std::size_t>(n + f));
  Eigen::Map<VectorXd>(y.data(), n) = start.q;
  Eigen::Map<VectorXd>(y.data() + n, f) = start.u;
  boost::numeric::odeint::runge_kutta_fehlberg78<Numbers> method;
  const double h = (t_end - start.t) / steps;
  for (int k = 0; k < steps; ++k) method.do_step(derivative, y, start.t + k * h, h);
  return {t_end, Eigen::Map<const VectorXd>(y.data(), n), Eigen::Map<const VectorXd>(y.data() + n, f)};
}

}  // namespace verify::integrators
