#include "contensou/system/tippe_top_euler.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contensou/text/number.hpp"

namespace contensou {
namespace {

using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;

}  // namespace

TippeTopEuler::TippeTopEuler(const TippeTopData& data, const std::array<SystemContact, 2>& contacts)
    : TippeTopModel(data, contacts) {}

void TippeTopEuler::mass_matrix(ConstVector q, Eigen::Ref<Eigen::MatrixXd> mass) const {
  const TippeTopData& d = data();
  const double s = std::sin(q[3]);
  const double c = std::cos(q[3]);
  mass.setZero();
  mass.diagonal() << d.m, d.m, d.m, d.i1, d.i1 * s * s + d.i3 * c * c, d.i3;
  mass(4, 5) = mass(5, 4) = d.i3 * c;
}

void TippeTopEuler::force(double /*t*/, ConstVector q, ConstVector u, VectorRef h) const {
  const auto& [m, i1, i3, g, a1, a2, r1, r2] = data();
  const double s = std::sin(q[3]);
  const double c = std::cos(q[3]);
  const double theta = u[3];
  const double phi = u[4];
  const double psi = u[5];
  h << 0, 0, -m * g, ((i1 - i3) * phi * c - i3 * psi) * phi * s,
      (2 * (i3 - i1) * phi * c + i3 * psi) * theta * s, i3 * phi * theta * s;
}

// M⁻¹ of (5.9): x_φ = (b_φ − cosθ b_ψ)/(I_1 sin²θ), x_ψ = b_ψ/I_3 − cosθ x_φ; here and in contact_rows with
// the common factor sinθ or sin²θ of b taken out by hand, which no elimination in doubles would do near 0.
void TippeTopEuler::free_acceleration(double /*t*/, ConstVector q, ConstVector u, VectorRef a) const {
  const double i1 = data().i1;
  const double i3 = data().i3;
  const double s = std::sin(q[3]);
  const double c = std::cos(q[3]);
  const double theta = u[3];
  const double phi = u[4];
  const double psi = u[5];
  const double precession = ((i3 - 2 * i1) * phi * c + i3 * psi) * theta / (i1 * s);
  a << 0, 0, -data().g, ((i1 - i3) * phi * c - i3 * psi) * phi * s / i1, precession,
      phi * theta * s - c * precession;
}

double TippeTopEuler::gap(std::size_t contact, double /*t*/, ConstVector q) const {
  return gap_at(contact, q[2], std::cos(q[3]));
}

void TippeTopEuler::contact_rows(std::size_t contact, double /*t*/, ConstVector q, ConstVector u,
                                 ContactRows& rows) const {
  const auto& [count, a, r, radius] = sphere(contact);
  const double inverse_m = 1 / data().m;
  const double inverse_i1 = 1 / data().i1;
  const double inverse_i3 = 1 / data().i3;
  const double s = std::sin(q[3]);
  const double c = std::cos(q[3]);
  const double theta = u[3];

  rows.directions.col(0).head<6>() << 0, 0, 1, -a * s, 0, 0;
  rows.response.col(0).head<6>() << 0, 0, inverse_m, -a * s * inverse_i1, 0, 0;
  rows.velocity[0] = u[2] - a * theta * s;
  rows.drift[0] = -a * theta * theta * c;
  if (count == 1) return;

  const double sf = std::sin(q[4]);
  const double cf = std::cos(q[4]);
  const double phi = u[4];
  const double psi = u[5];
  const double h = a * c - r;
  const double precession = (a - r * c) * inverse_i1 / s;   // (M⁻¹W_T)_φ of a push along the nodal axis
  const double spin = r * s * inverse_i3 - c * precession;  // and its (M⁻¹W_T)_ψ
  rows.directions.col(1).head<6>() << 1, 0, 0, h * sf, a * s * cf, r * s * cf;
  rows.directions.col(2).head<6>() << 0, 1, 0, -h * cf, a * s * sf, r * s * sf;
  rows.response.col(1).head<6>() << inverse_m, 0, 0, h * sf * inverse_i1, precession * cf, spin * cf;
  rows.response.col(2).head<6>() << 0, inverse_m, 0, -h * cf * inverse_i1, precession * sf, spin * sf;
  // γ_T = v_S + along (cosφ, sinφ) + across (sinφ, −cosφ), (5.19); the two turn with φ̇.
  const double along = (a * phi + r * psi) * s;
  const double across = theta * h;
  rows.velocity[1] = u[0] + along * cf + across * sf;
  rows.velocity[2] = u[1] + along * sf - across * cf;
  const double along_rate = (a * phi + r * psi) * c * theta + across * phi;
  const double across_rate = -a * s * theta * theta - along * phi;
  rows.drift[1] = along_rate * cf + across_rate * sf;
  rows.drift[2] = along_rate * sf - across_rate * cf;
  if (count == 3) return;

  rows.directions.col(3).head<6>() << 0, 0, 0, 0, radius, radius * c;
  rows.response.col(3).head<6>() << 0, 0, 0, 0, radius * inverse_i1, radius * c * (inverse_i3 - inverse_i1);
  rows.velocity[3] = radius * (phi + psi * c);
  rows.drift[3] = -radius * psi * s * theta;
}

double TippeTopEuler::kinetic_energy(ConstVector q, ConstVector u) const {
  const double across = u[4] * std::sin(q[3]);
  const double along = u[5] + u[4] * std::cos(q[3]);
  return (data().m * u.head<3>().squaredNorm() + data().i1 * (across * across + u[3] * u[3]) +
          data().i3 * along * along) /
         2;
}

double TippeTopEuler::potential_energy(ConstVector q) const { return data().m * data().g * q[2]; }

State TippeTopEuler::start(double theta, double psi_dot, std::optional<double> z_s) const {
  const double z = starting_height(theta, psi_dot, z_s);
  if (theta == 0 || theta == std::numbers::pi)
    throw std::invalid_argument("tippe-top: theta " + to_text(theta) +
                                ", expected one between 0 and pi: Euler angles are singular there");
  return {0, Vector6{{0, 0, z, theta, 0, 0}}, Vector6{{0, 0, 0, 0, 0, psi_dot}}};
}

double TippeTopEuler::inclination(ConstVector q) const {
  return std::abs(std::remainder(q[3], 2 * std::numbers::pi));
}

Eigen::Vector3d TippeTopEuler::axis(ConstVector q) const {
  const double s = std::sin(q[3]);
  return {std::sin(q[4]) * s, -std::cos(q[4]) * s, std::cos(q[3])};
}

Eigen::Vector3d TippeTopEuler::spin(ConstVector q, ConstVector u) const {
  const Vector3d node(std::cos(q[4]), std::sin(q[4]), 0);
  return u[3] * node + u[4] * Vector3d::UnitZ() + u[5] * axis(q);
}

}  // namespace contensou
