// LG03 Section 4.1, first half: the equation of motion and its discretisation, (4.1) to (4.9), on the paper's
// own example, the tippe-top of Section 5.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "inclusion.hpp"
#include "oracle.hpp"
#include "top_oracle.hpp"

namespace verify::ledger {
namespace {

using namespace top;

Finding motion() {
  std::vector<Trial> trials;
  const State s = generic();
  for (const int i : {0, 1}) {
    const Eigen::Vector4d force(60, 20, -15, 100);  // accelerations of order ten
    const Vector6 acceleration = top::acceleration(s, directions(i, s.q) * force);
    // Newton and Euler: momentum and angular momentum about the centre of mass.
    const Vector3d push(force[1], force[2], force[0]);
    const Vector3d torque = arm(i, s.q).cross(push) + Vector3d(0, 0, force[3] * radius);
    const auto momentum = [](const State& x) {
      const Matrix3d body = attitude(x.q);
      return (body * Vector3d(i1, i1, i3).asDiagonal() * body.transpose() * spin(x)).eval();
    };
    const Vector3d linear = m * acceleration.head<3>() - push + Vector3d(0, 0, m * g);
    const Vector3d angular = rate(momentum, s, acceleration) - torque;
    trials.push_back(absolute(0, linear.norm() / push.norm()));
    trials.push_back(absolute(0, angular.norm() / torque.norm()));
  }
  const Trial t = worst(trials);
  return {
      t,
      {},
      differences,
      "The tippe-top, M, h, W of (5.9), (5.16), (5.20), (5.21), a force and a torque on body or tip in a "
      "generic "
      "state: accelerations against Newton's and Euler's laws, the angular momentum differentiated: relative "
      "difference " +
          text(t.error, 2)};
}

Finding contact_laws() {
  int wrong = 0;
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      const double gap = 0.25 * i;
      const double force = 0.5 * j;
      // −g ∈ N_{R+}(λ): λ >= 0 and −g (c − λ) <= 0 for all c >= 0
      bool inside = force >= 0;
      for (double c = 0; c <= 8; c += 0.5) inside = inside && -gap * (c - force) <= 0;
      if (inside != (gap >= 0 && force >= 0 && gap * force == 0)) ++wrong;
    }
  }
  return {absolute(0, wrong),
          {},
          0,
          "−g_N ∈ N_{R+}(λ_N) and 0 <= g_N ⊥ λ_N >= 0 on 81 pairs, by the definition of the normal cone: " +
              text(wrong) + " disagree. The second law is (2.20)"};
}

Finding contact_level() {
  // A body of weight 1 rests on the floor: the largest force on a grid that an instant's law lets pass.
  double largest = 0;
  double accelerated = 0;
  for (int j = 0; j <= 40; ++j) {
    const double force = 0.1 * j;
    const double acceleration = force - 1;
    largest = std::max(largest, force);  // g_N = 0: every λ_N >= 0 passes
    if (acceleration >= -1e-12 && std::abs(acceleration * force) < 1e-12) accelerated = force;
  }
  return {relative(1, largest), relative(1, accelerated), 1e-12,
          "A body of weight 1 at rest on the floor: with g_N = 0 the law −g_N ∈ N(λ_N) lets every λ_N >= 0 "
          "pass (grid "
          "to " +
              text(largest) + "); −g̈_N ∈ N(λ_N) leaves only λ_N = " + text(accelerated)};
}

/// A block of unit mass falls, strikes the floor (ε = 0) while it moves on at v, rubs to rest: (ẋ, ẏ)(t) in
/// closed form, and its impulses.
struct Landing {
  static constexpr double weight = 2, strikes = 1, mu = 0.25, fast = 3;
  static double slowed(double t) {
    return std::max(0.0, fast - mu * weight * strikes - mu * weight * (t - strikes));
  }
  static double x(double t) { return t < strikes ? fast : slowed(t); }
  static double y(double t) { return t < strikes ? -weight * t : 0; }
  static constexpr double rests = strikes + (fast - mu * weight * strikes) / (mu * weight);
};

/// M du = h dt + W(λ dt + Λ dη) over an interval: what is left, (x, y).
Eigen::Vector2d measures(double from, double to) {
  const auto overlap = [&](double low, double high) {
    return std::max(0.0, std::min(to, high) - std::max(from, low));
  };
  const bool strikes = from < Landing::strikes && to >= Landing::strikes;
  const double normal =
      Landing::weight * overlap(Landing::strikes, 1e9) + (strikes ? Landing::weight * Landing::strikes : 0);
  const double friction = -Landing::mu * (Landing::weight * overlap(Landing::strikes, Landing::rests) +
                                          (strikes ? Landing::weight * Landing::strikes : 0));
  return {Landing::x(to) - Landing::x(from) - friction,
          Landing::y(to) - Landing::y(from) + Landing::weight * (to - from) - normal};
}

Finding equality_of_measures() {
  double largest = 0;
  for (double from = 0; from < 8; from += 0.3) {
    for (double to = from + 0.07; to < 9; to += 0.41) largest = std::max(largest, measures(from, to).norm());
  }
  return {
      absolute(0, largest),
      {},
      1e-14,
      "A sliding block that lands (ε_N = 0), rubs and comes to rest, in closed form; u of bounded variation, "
      "du = u̇ dt + (u⁺ − u⁻) dη: largest remainder over 594 intervals, with and without the impact, " +
          text(largest, 2)};
}

Finding briefer() {
  const State s = generic();
  const Eigen::Matrix<double, 6, 4> w = directions(0, s.q);
  const Eigen::Vector4d impulse(0.7, -0.2, 0.1, 0.05);
  const double difference =
      (w * impulse - w.col(0) * impulse[0] - w.rightCols<3>() * impulse.tail<3>()).norm();
  return {absolute(0, difference),
          {},
          1e-15,
          "W = (W_N, W_F), Λ = (Λ_N, Λ_F): difference " + text(difference, 2)};
}

/// Wᵀu against the velocity of the material point, at velocities before and after an impact.
Finding velocities() {
  std::vector<Trial> trials;
  for (const int i : {0, 1}) {
    State s = generic();
    const Eigen::Matrix<double, 6, 4> w = directions(i, s.q);
    for (int k = 0; k < 2; ++k) {
      const Eigen::Vector4d direct = contact_velocity(i, s);
      trials.push_back(absolute(0, (w.transpose() * s.u - direct).norm() / direct.norm()));
      const auto gap = [&](const State& x) { return Eigen::Matrix<double, 1, 1>(x.q[2] + arm(i, x.q)[2]); };
      trials.push_back(
          absolute(0, (rate(gap, s, Vector6::Zero())[0] - (w.transpose() * s.u)[0]) / direct.norm()));
      s.u += response(s.q[3], w * Eigen::Vector4d(4, 0.5, -0.3, 0.2));
    }
  }
  const Trial t = worst(trials);
  return {t,
          {},
          differences,
          "Tippe-top, body and tip, before and after an impulse: Wᵀu (w̃ = 0) against ġ_N, v_S + ω × r_SC and "
          "ω_3R "
          "with ω from the attitude's derivative: relative difference " +
              text(t.error, 2)};
}

Finding averaged_force() {
  // h(t) = cos t over a step of x/10 from t = 1.4, where the next term is a tenth of the first times x/10.
  const Trial t = order(
      [](const Real& argument) -> Real {
        const Real start = ratio(7, 5);
        const Real x = argument / 10;
        return sin(start + x) - sin(start) - x * cos(start);
      },
      2);
  return {t,
          {},
          order_bound,
          "∫h dt − hΔt with h at the start of the step falls with the power " + text(t.obtained, 5) +
              " of Δt (with h at the middle, as in 4.2, with the third)"};
}

Finding one_letter() {
  // The block lands in the middle of a step: momentum says what ∫dΛ_N is.
  const double from = 0.95;
  const double to = 1.05;
  const double total = Landing::y(to) - Landing::y(from) + Landing::weight * (to - from);
  const double atom = Landing::weight * Landing::strikes;
  const double lasting = Landing::weight * (to - Landing::strikes);
  return {relative(total, atom), relative(total, atom + lasting), 1e-14,
          "The block lands within a step of 0.1: ∫dΛ_N = " + text(total) +
              " by its momentum, the atom Λ_N of dΛ = "
              "λ dt + Λ dη is " +
              text(atom)};
}

Finding motion_in_differences() {
  const auto remainder = [](double step) {
    const State s = generic();
    const Vector6 change = flown(s, step, 64).u - s.u;
    return (mass(s.q[3]) * change - smooth(s) * step).tail<3>().norm();
  };
  // Steps so small that the next term, of the order of Δt, does not count, and rounding (1e-16/Δt²) neither.
  const double measured = std::log10(remainder(1e-3) / remainder(1e-4));
  return {absolute(2, measured),
          {},
          order_bound,
          "Tippe-top in free flight, M and h at the start of the step: the remainder falls with the power " +
              text(measured, 5) + " of Δt"};
}

Finding impulse_laws() {
  int wrong = 0;
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      const double gamma = 0.25 * i;
      const double impulse = 0.5 * j;
      // −Λ ∈ ∂Ψ_{R+}(γ): γ >= 0 and −Λ (c − γ) <= 0 for all c >= 0
      bool inside = gamma >= 0;
      for (double c = 0; c <= 8; c += 0.25) inside = inside && -impulse * (c - gamma) <= 0;
      if (inside != (gamma >= 0 && impulse >= 0 && gamma * impulse == 0)) ++wrong;
    }
  }
  // −Λ_F ∈ ∂Φ(γ_F): −Λ_F·(c − γ) <= Φ(c) − Φ(γ) for all c; against −γ_F ∈ N_B(Λ_F): −γ·(b − Λ) <= 0, b ∈ B.
  const std::vector<Vector3d> ball = hertz_ball::cover(24);
  std::vector<std::pair<Vector3d, double>> velocities;
  for (const Vector3d& b : ball) velocities.emplace_back(b, hertz_ball::support(b));
  const auto agree = [&](const Vector3d& gamma, const Vector3d& impulse) {
    double primal = -1e9;
    double dual = -1e9;
    const double phi = hertz_ball::support(gamma);
    for (const auto& [c, value] : velocities) {
      for (const double scale : {0.3, 1.0, 4.0}) {
        primal = std::max(primal, -impulse.dot(scale * c - gamma) - scale * value + phi);
      }
    }
    // Λ in the ball, tested by the same planes, and above every point of it
    for (const auto& [c, value] : velocities) dual = std::max(dual, (impulse.dot(c) - value) / c.norm());
    for (const Vector3d& b : ball) dual = std::max(dual, -gamma.dot(b - impulse));
    return (primal < 1e-9) == (dual < 1e-9);
  };
  int count = 0;
  for (int k = 0; k < 60; ++k) {
    const Vector3d gamma(std::sin(1.0 * k), std::cos(2.0 * k), std::sin(3.0 * k + 1));
    const Eigen::Vector2d b = hertz_ball::border(gamma.head<2>().norm(), std::abs(gamma[2]));
    Vector3d slip;
    slip << -gamma.head<2>().normalized() * b[0], -std::copysign(b[1], gamma[2]);
    for (const Vector3d& impulse : {slip, Vector3d(0.8 * slip), Vector3d(1.1 * slip), Vector3d(-slip)}) {
      count += 2;
      if (!agree(gamma, impulse)) ++wrong;
      if (!agree(Vector3d::Zero(), impulse)) ++wrong;
    }
  }
  return {absolute(0, wrong),
          {},
          0,
          "Normal law against 0 <= γ_N⁺ ⊥ Λ_N >= 0 on 81 pairs; −Λ_F ∈ ∂Φ(γ_F⁺), jointly in the three "
          "components, "
          "against −γ_F⁺ ∈ N_B(Λ_F) on " +
              text(count) + " pairs, by the definitions over " + text(ball.size()) +
              " points: " + text(wrong) + " disagree"};
}

/// A body falls from one metre onto the floor in steps of 0.01 s, (4.7) to (4.9), and is followed until it
/// has been down for ten steps: speed against the conservation of energy above the floor, and zero on it.
Trial fall(bool closed_only) {
  constexpr double dt = 0.01;
  constexpr double gravity = 9.81;
  constexpr double mass = 2;
  Inclusion i = sliding();
  i.mass = mass * Eigen::Matrix<double, 6, 6>::Identity();
  i.smooth = -mass * gravity * dt * Vector6::Unit(2);
  i.w_n = Vector6::Unit(2);
  i.w_f.setZero();
  i.w_f(0, 0) = i.w_f(1, 1) = i.w_f(5, 2) = 1;
  i.before = -Vector6::Unit(2);
  double gap = 1;
  int down = 0;
  std::vector<Trial> trials;
  for (int k = 0; k < 100 && down < 10; ++k) {
    const bool closed = gap <= 0;
    const Vector6 change = !closed && closed_only ? i.motion(0, Vector3d::Zero()) : i.solve().change;
    const double after = i.gamma_n(change);
    gap += dt * (i.gamma_n(Vector6::Zero()) + after) / 2;  // exact in free fall
    i.before += change;
    if (closed) {
      ++down;
      trials.push_back(absolute(0, after));
    } else {
      trials.push_back(absolute(-std::sqrt(1 + 2 * gravity * (1 - gap)), after));
    }
  }
  if (closed_only) trials.push_back(absolute(10, down));
  return worst(trials);
}

Finding closed_contacts() {
  const Trial all = fall(false);
  const Trial closed = fall(true);
  // At most 100 steps of some ten roundings of numbers up to 5.
  return {
      all, closed, 1e-12,
      "A body falls at 1 m/s, one metre above the floor, Δt = 0.01 s. With the laws of all contacts it has "
      "γ_N⁺ = " +
          text(all.obtained) + " m/s where free fall has " + text(all.expected) +
          "; with those of closed contacts it falls freely and then rests, to " + text(closed.error, 2) +
          " m/s"};
}

}  // namespace

std::vector<Row> section4() {
  std::vector<Row> rows{
      {"4.1", "(4.1)", "Mu̇ − h − W_Nλ_N − W_Fλ_F = 0", Flaw::none, "", "", motion},
      {"4.2", "(4.2)", "−g_N ∈ N_{C_N}(λ_N), −γ_F ∈ N_{B_F(λ_N)}(λ_F)", Flaw::none, "",
       "C_N is not said to be R+.", contact_laws},
      {"4.2.level", "(4.2), the level of the normal law", "−g_N ∈ N_{C_N}(λ_N) on displacement level",
       Flaw::imprecise, "for closed contacts −γ_N, and where γ_N = 0 −γ̇_N, in place of −g_N",
       "True of the motion as a whole; at an instant it does not determine λ_N. The library takes it on "
       "velocity "
       "level, (4.8), and on acceleration level.",
       contact_level},
      {"4.3", "(4.3)", "M du − h dt − W_N dΛ_N − W_F dΛ_F = 0", Flaw::none, "", "", equality_of_measures},
      {"4.4", "(4.4)", "M du − h dt − W dΛ = 0", Flaw::none, "", "", briefer},
      {"4.5", "(4.5)", "γ± = Wᵀu± + w̃", Flaw::none, "", "", velocities},
      {"4.6", "(4.6)", "∫du = Δu, ∫h dt ≈ hΔt, ∫dΛ = Λ", Flaw::none, "", "", averaged_force},
      {"4.6.letter", "(4.6), Λ", "∫dΛ = Λ, after dΛ = λ dt + Λ dη", Flaw::imprecise,
       "∫dΛ = ∫λ dt + ΣΛ, one letter each",
       "From (4.6) on Λ is the integral over the step; it grows with Δt in lasting contact.", one_letter},
      {"4.7", "(4.7)", "MΔu − hΔt − W_NΛ_N − W_FΛ_F = 0", Flaw::none, "", "", motion_in_differences},
      {"4.8", "(4.8)", "−Λ_N ∈ ∂Ψ_{R+}(γ_N⁺), −Λ_F ∈ ∂Φ(γ_F⁺)", Flaw::none, "",
       "Here the friction law is joint in (γ_T, γ_τ), as it must be at rest; (2.11) is not. In Φ stands Λ_N "
       "for λ_N.",
       impulse_laws},
      {"4.8.closed", "(4.8), which contacts", "the force laws of all contacts", Flaw::imprecise,
       "those with g_N <= 0 only", "Section 4.2 says so: I_N.", closed_contacts},
      {"4.9", "(4.9)", "γ⁺ = Wᵀ(u⁻ + Δu) + w̃", Flaw::none, "", "", velocities},
  };
  const std::vector<Row> more = augmented_lagrangian();
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace verify::ledger
