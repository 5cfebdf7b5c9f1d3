// LG03 Sections 5 and 5.4: what the text says about the geometry, the data and the initial state of the
// tippe-top. Lengths are in 1e-2 m, masses in 1e-3 kg, as in top_oracle.hpp.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "inclusion.hpp"
#include "oracle.hpp"
#include "top_oracle.hpp"

namespace verify::ledger {
namespace {

using namespace top;

constexpr double mu = 0.3;
constexpr double inclined = 0.1;

/// The initial state of 5.4.
State initial() {
  State s;
  s.q << 0, 0, 1.2015, inclined, 0, 0;
  s.u << 0, 0, 0, 0, 0, 180;
  return s;
}

Finding geometry() {
  // Above the centre of mass, along the axis: top of the body, top of the tip, middle of body and tip.
  const double out = (a[1] + r[1]) - (a[0] + r[0]);
  const double attached = std::abs(a[1] - a[0]) - (r[0] + r[1]);
  return {worst({at_most_zero(-out), at_most_zero(attached), at_most_zero(a[0] - a[1])}),
          {},
          0,
          "N lies " + text(a[1] - a[0]) + " cm above M, the tip stands " + text(out, 2) +
              " cm out of the body's sphere, their spheres overlap by " + text(-attached, 2) + " cm"};
}

/// The contact radius in metres by the approach d of the bodies: λ = 4/3 E* √ϱ d^{3/2}, R² = ϱd.
double by_approach(double curvature) {
  constexpr double modulus = 5e9;
  const double load = 6e-3 * 9.81;
  const double approach = std::pow(3 * load / (4 * modulus * std::sqrt(curvature)), 2.0 / 3);
  return std::sqrt(curvature * approach);
}
double hertz_radius(double curvature) { return std::cbrt(3 * curvature * 6e-3 * 9.81 / (4 * 5e9)); }

Finding hertz_formula() {
  const Trial t = relative(by_approach(0.015), hertz_radius(0.015));
  return {t,
          {},
          1e-14,
          "The formula, (3.2) without its number, against λ_N = 4/3 E* √ϱ* d^{3/2}, R² = ϱ*d: " +
              text(t.error, 2)};
}

Finding hertz_value() {
  const double value = by_approach(0.015);
  return {relative(5e-5, value),
          {},
          0.1,  // one digit is given: half a unit of it
          "ϱ* = 15 mm, E* = 5 GPa, λ_N = mg = " + text(6e-3 * 9.81, 4) + " N: R_Hertz = " + text(value, 4) +
              " m"};
}

Finding curvature() {
  const auto relative_curvature = [](double sphere) { return 1 / (1 / sphere + 0.0); };
  return {worst({relative(relative_curvature(r[0]), r[0]), relative(relative_curvature(r[1]), r[0])}),
          worst({relative(relative_curvature(r[0]), r[0]), relative(relative_curvature(r[1]), r[1])}), 1e-15,
          "1/ϱ* = 1/r_i + 0 on a flat floor. For the tip R_Hertz = " + text(by_approach(0.005), 4) + " m"};
}

Finding roughness() {
  const double least = 1e-4 / by_approach(0.015);
  const double most = 1e-3 / by_approach(0.015);
  return {at_most_zero(10 - least), worst({at_most_zero(1 - least), at_most_zero(10 - most)}), 0,
          "1e-4 to 1e-3 m are " + text(least, 3) + " to " + text(most, 3) +
              " times R_Hertz; \"much\" is taken to be ten times"};
}

/// What the friction of the body contact is of λ_N in the initial state: (T1, T2, τ), Hertz pressure.
Eigen::Vector3d friction_part(const State& s) {
  const Eigen::Vector4d gamma = contact_velocity(0, s);
  const Eigen::Vector2d v = gamma.segment<2>(1);
  const Eigen::Vector2d size = mu * hertz_ball::border(v.norm(), std::abs(gamma[3]));
  Eigen::Vector3d f;
  f << -size[0] * v.normalized(), -std::copysign(size[1], gamma[3]);
  return f;
}

Finding stationary_force() {
  State s = initial();
  s.q[2] = r[0] - a[0] * std::cos(inclined);
  const Eigen::Matrix<double, 6, 4> w = directions(0, s.q);
  const Vector6 unit = w.col(0) + w.rightCols<3>() * friction_part(s);
  // g̈_N1 = 0; at rest but for the spin Ẇᵀu = 0.
  const double force = -w.col(0).dot(top::acceleration(s)) / w.col(0).dot(response(inclined, unit));
  return {relative(m * g, force),
          {},
          0.01,  // a change of 1 % in λ_N is 0.3 % of R_Hertz, which is given to one digit
          "In the initial state, body in contact and slipping, λ_N = " + text(force / (m * g), 6) +
              " mg from g̈_N1 = 0; in steady motion at constant θ it is mg"};
}

Finding initial_gap() {
  const State s = initial();
  const double length = s.q[2] + arm(0, s.q)[2];
  const double touching = r[0] - a[0] * std::cos(inclined);
  return {absolute(0, length), absolute(0, touching + arm(0, s.q)[2]), 1e-15,  // a few roundings of 1.5
          "z_S0 = 1.2015e-2 m leaves g_N1 = " + text(length / 100, 4) +
              " m; g_N1 = 0 is at z_S0 = r_1 − a_1 cos θ_0 = " + text(touching / 100, 10) +
              " m. It falls for " + text(std::sqrt(2 * length / g), 3) + " s and lands at " +
              text(std::sqrt(2 * length * g) / 100, 3) + " m/s"};
}

Finding tip_open() {
  const State s = initial();
  const double length = s.q[2] + arm(1, s.q)[2];
  return {at_most_zero(-length), {}, 0, "g_N2 = " + text(length / 100, 5) + " m"};
}

Finding resting() {
  const State s = initial();
  const Eigen::Vector4d gamma = contact_velocity(0, s);
  const double slip = gamma.segment<2>(1).norm();
  return {absolute(0, slip), absolute(0, gamma[0]), differences,
          "γ_N1 = " + text(gamma[0], 2) + ", but ‖γ_T1‖ = r_1ψ̇_0 sin θ_0 = " + text(slip / 100, 4) +
              " m/s and γ_τ1 = " + text(gamma[3] / 100, 4) + " m/s, u = " + text(slip / gamma[3], 4)};
}

Finding spin_axis() {
  const State s = initial();
  const Trial t = absolute(0, spin(s).normalized().cross(attitude(s.q).col(2)).norm());
  return {
      t, {}, differences, "ω by differences against e_3⁴: the sine of their angle is " + text(t.error, 2)};
}

Finding friction_torque() {
  const State s = initial();
  const Eigen::Vector3d f = friction_part(s);
  const Vector3d torque = arm(0, s.q).cross(Vector3d(f[0], f[1], 0)) + Vector3d(0, 0, radius * f[2]);
  const double upright = std::abs(torque.normalized()[2]);
  const Vector3d node = Vector3d::UnitX();  // e_1² at φ = 0
  return {absolute(1, upright), absolute(0, torque.normalized().dot(node)), differences,
          "In the initial state the torque of the friction about S has the components " + text(torque[0], 2) +
              ", " + text(torque[1], 4) + ", " + text(torque[2], 3) +
              " (e¹, units of λ_N times 1 cm): " + text(100 * upright, 2) +
              " % of it is along e_3¹, of which drilling gives " + text(radius * f[2], 3) +
              "; the rest, λ_T times the height of S, is level and normal to the nodal axis"};
}

}  // namespace

std::vector<Row> section5_data() {
  return {
      {"s5.geometry", "Section 5, Fig. 7",
       "S lies at a distance a_1 below M and at a distance a_2 from N, on a stick on top of the body",
       Flaw::none, "", "", geometry},
      {"s5.4.realistic",
       "Section 5.4, data",
       "The parameters are realistic for a wooden commercial Tippe-Top; μ = 0.3, ε_N = 0, E* = 5 GPa for "
       "wood",
       Flaw::not_checkable,
       "",
       "",
       {},
       "Realistic names no bound. A full ball of 6 g and r_1 would weigh 424 kg/m³, and I_3 < 2I_1: nothing "
       "impossible."},
      {"s5.4.3.2", "Section 5.4, R_Hertz", "R_Hertz = (3ϱ*λ_N/(4E*))^{1/3}", Flaw::none, "",
       "(3.2) once more, without a number.", hertz_formula},
      {"s5.4.value", "Section 5.4, value of R_Hertz", "about 5e-5 m", Flaw::none, "",
       "A tenth of the R = 5e-4 m used.", hertz_value},
      {"s5.4.curvature", "Section 5.4, ϱ*", "the underground is flat and therefore ϱ* = r_1", Flaw::imprecise,
       "ϱ* = r_i", "Right for the body, three times too large for the tip.", curvature},
      {"s5.4.roughness", "Section 5.4, roughness",
       "much less than the surface roughness of wood (1e-4 to 1e-3 m)", Flaw::imprecise,
       "half to a twentieth of it",
       "A radius along the surface is compared with a height; nothing in the laws follows from it.",
       roughness},
      {"s5.4.expected",
       "Section 5.4, constant R",
       "the radius does not follow Hertz' law but depends on the roughness of the contacting bodies",
       Flaw::not_checkable,
       "",
       "",
       {},
       "An expectation about real surfaces; nothing is computed or measured. R is then a parameter."},
      {"s5.4.force", "Section 5.4, λ_N", "approximately equal to its stationary value λ_N ≈ mg", Flaw::none,
       "", "At the start. In impacts, of course, it is not.", stationary_force},
      {"s5.4.gap", "Section 5.4, g_N1 at the start", "z_S0 = 1.2015e-2 m, θ_0 = 0.1, i.e., g_N1 = 0",
       Flaw::imprecise, "z_S0 = r_1 − a_1 cos θ_0",
       "Right to the digits given. A simulation that takes them begins with a fall and a tiny impact.",
       initial_gap},
      {"s5.4.tip", "Section 5.4, g_N2 at the start", "g_N2 > 0", Flaw::none, "", "", tip_open},
      {"s5.4.rest", "Section 5.4, rest", "resting with its body on the floor", Flaw::imprecise,
       "γ_N1 = 0, in fast slip", "", resting},
      {"s5.4.axis", "Section 5.4, spin at the start", "spinning around its axis of revolution", Flaw::none,
       "", "", spin_axis},
      {"s5.4.torque", "Section 5.4, frictional torque",
       "The friction forces cause a frictional torque along the e_3¹ axis", Flaw::imprecise,
       "a torque normal to the nodal axis e_1², of which a small part is along e_3¹",
       "About S. The force λ_T has the larger part in it; the drilling torque is a fraction of a percent.",
       friction_torque},
  };
}

}  // namespace verify::ledger
