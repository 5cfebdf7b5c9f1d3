// LG03 Section 4.2: the time-stepping methods of Tables 1 and 2, (4.18) to (4.20). The tables are put into
// practice here once more, to the letter, on motions in closed form, on the tippe-top in free flight and on a
// block that meets a floor.

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "elimination.hpp"
#include "inclusion.hpp"
#include "oracle.hpp"
#include "top_oracle.hpp"

namespace verify::ledger {
namespace {

using top::State;

/// Of an error cΔtᵖ(1 + O(Δt)) between Δt = 1e-3 and 1e-4, rates of order one: log10(1 + O(1e-3)).
constexpr double measured_order = order_bound;

// Motions of one degree of freedom, q̈ = f(q, q̇), in closed form, from t = 2/5 to 7/5.

struct Phase {
  Real q;
  Real u;
};
using Force = Real (*)(const Real& q, const Real& u);
struct Line {
  Force force;
  Phase (*at)(const Real& t);
};

const Line by_position{[](const Real& q, const Real&) -> Real { return 2 * q * (q * q - 1); },
                       [](const Real& t) -> Phase {
                         const Real q = tanh(t);
                         return {q, 1 - q * q};
                       }};
const Line by_velocity{[](const Real&, const Real& u) -> Real { return 1 - u * u; },
                       [](const Real& t) -> Phase {
                         return {log(cosh(t)), tanh(t)};
                       }};
const Line by_both{[](const Real& q, const Real& u) -> Real { return -2 * q * u; }, by_position.at};

/// One step of Table 1 with an open contact; `implicit` takes h at (u_A + u_E)/2 in place of u_A.
Phase moreau(Force f, const Phase& a, const Real& dt, bool implicit) {
  const Real middle = a.q + dt / 2 * a.u;
  Real end = a.u + dt * f(middle, a.u);
  // Each repetition gains a factor of Δt, at most 1e-3: 30 digits.
  for (int k = 0; implicit && k < 10; ++k) end = a.u + dt * f(middle, (a.u + end) / 2);
  return {middle + dt / 2 * end, end};
}

/// a_m of Table 2 with an open contact, and what it stands for.
Real stage_printed(Force f, const Phase& a, const Real& dt) {
  const Real dt2 = dt / 4;
  const Real end = a.u + dt2 * f(a.q + dt2 / 2 * a.u, a.u);
  return (end - a.u) / dt2;
}
Real stage_meant(Force f, const Phase& a, const Real&) { return f(a.q, a.u); }

/// One step of Table 2 with that stage.
template <class Stage>
Phase table2(Force f, const Phase& start, const Real& dt, Stage stage) {
  const std::array<Real, 4> c{0, ratio(1, 2), ratio(1, 2), 1};
  const std::array<Real, 4> b{ratio(1, 6), ratio(1, 3), ratio(1, 3), ratio(1, 6)};
  Phase end = start;
  Real u = start.u;
  Real a = stage(f, start, dt);
  for (std::size_t k = 0; k < 4; ++k) {
    if (k > 0) {
      const Phase x{start.q + c[k] * dt * u, start.u + c[k] * dt * a};
      u = x.u;
      a = stage(f, x, dt);
    }
    end.q += b[k] * dt * u;
    end.u += b[k] * dt * a;
  }
  return end;
}

/// The measured order of a step function against the closed form.
template <class Step>
Trial line_order(const Line& line, int claimed, Step step) {
  return order(
      [&](const Real& x) -> Real {
        const int count = static_cast<int>(round(10 / x));
        Phase s = line.at(ratio(2, 5));
        for (int k = 0; k < count; ++k) s = step(line.force, s, Real(1) / count);
        const Phase exact = line.at(ratio(7, 5));
        return abs(s.q - exact.q) + abs(s.u - exact.u);
      },
      claimed);
}

/// Table 1 and Table 2 for the top in free flight.
State moreau(const State& a, double dt, bool implicit) {
  const top::Vector6 middle = a.q + dt / 2 * a.u;
  top::Vector6 end = a.u + dt * top::acceleration({middle, a.u});
  for (int k = 0; implicit && k < 6; ++k) end = a.u + dt * top::acceleration({middle, (a.u + end) / 2});
  return {middle + dt / 2 * end, end};
}
State runge_kutta(const State& start, double dt, bool displaced) {
  constexpr double c[] = {0, 0.5, 0.5, 1};
  constexpr double b[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  const auto stage = [&](const State& x) {
    // (u_E − u_A)/Δt2, and what it stands for
    return top::acceleration({displaced ? x.q + dt / 8 * x.u : x.q, x.u});
  };
  State end = start;
  State x = start;
  top::Vector6 a;
  for (int k = 0; k < 4; ++k) {
    if (k > 0) x = {start.q + c[k] * dt * x.u, start.u + c[k] * dt * a};
    a = stage(x);
    end.q += b[k] * dt * x.u;
    end.u += b[k] * dt * a;
  }
  return end;
}

/// The order between a quarter of a second in so many steps and in ten times as many. The reference's own
/// error, (1e-4)⁴, is below rounding.
template <class Step>
Trial top_order(int claimed, int steps, Step step) {
  constexpr double time = 0.25;
  const State reference = top::flown(top::generic(), time, 2500);
  const auto error = [&](int count) {
    State s = top::generic();
    for (int k = 0; k < count; ++k) s = step(s, time / count);
    return (s.q - reference.q).tail<3>().norm() + (s.u - reference.u).tail<3>().norm();
  };
  return absolute(claimed, std::log10(error(steps) / error(10 * steps)));
}

Finding midpoint_equation() {
  const State start = top::generic();
  const auto remainder = [&](double dt) {
    const State end = top::flown(start, dt, 64);
    const State middle{start.q + dt / 2 * start.u, top::flown(start, dt / 2, 32).u};
    return (top::mass(middle.q[3]) * (end.u - start.u) - top::smooth(middle) * dt).tail<3>().norm();
  };
  // Next term: Δt times the first. Rounding 1e-15 against (1e-3)³.
  const double measured = std::log10(remainder(1e-2) / remainder(1e-3));
  return {absolute(3, measured),
          {},
          10 * measured_order,  // log10(1 + O(1e-2)) and rounding 1e-15/1e-9
          "Tippe-top in free flight, M_M and h_M at q_M and at the velocity of the midpoint: (4.18) leaves a "
          "remainder that falls with the power " +
              text(measured, 5) + " of Δt, as of a second-order method"};
}

Finding trapezoidal_rule() {
  // u̇ = cos t over a step of 1/10 from 7/5; (4.18) takes h at the middle.
  const Real dt = ratio(1, 10);
  const Real t = ratio(7, 5);
  const Real equation = dt * cos(t + dt / 2);
  const Real trapezoid = dt * (cos(t) + cos(t + dt)) / 2;
  const Real half = dt / 2;
  const Phase a{1, ratio(1, 3)};
  const Phase e = moreau(by_both.force, a, dt, false);
  const Trial positions = relative(a.q + half * (a.u + e.u), e.q);
  return {relative(trapezoid, equation), worst({relative(dt * cos(t + half), equation), positions}), digits50,
          "For u̇ = cos t (4.18) gives Δt cos(t_M), the trapezoidal rule differs by " +
              text(trapezoid / equation - 1, 3) + " of it at Δt = 0.1. q_E = q_A + Δt(u_A + u_E)/2 to " +
              text(positions.error, 2)};
}

Finding step_laws() {
  std::vector<Trial> trials;
  for (const Inclusion& i : {sliding(), sticking()}) {
    const Inclusion::Point p = i.solve();
    const double size = i.mu * p.normal;
    const Eigen::Vector3d gamma = i.gamma_f(p.change);
    trials.push_back(at_most_zero(-p.normal));
    trials.push_back(absolute(0, i.gamma_n(p.change)));
    // −Λ ∈ ∂Φ(γ): −Λ·γ = Φ(γ), and −Λ·c <= Φ(c) everywhere
    trials.push_back(absolute(0, p.friction.dot(gamma) + size * hertz_ball::support(gamma)));
    for (const Eigen::Vector3d& c : hertz_ball::cover(16))
      trials.push_back(at_most_zero(-p.friction.dot(c) - size * hertz_ball::support(c)));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          1e-10,  // the ball's 1e-12 and that of the iteration, numbers up to ten
          "A sliding and a sticking contact solved as in Table 1: both laws at γ⁺ = Wᵀu_E + w̃, that of "
          "friction by Φ's subgradients, to " +
              text(t.error, 2)};
}

Finding midpoint_solver() {
  // Oscillator, ωΔt = 3: the spectral radius of a step. The midpoint rule is a rotation at every step size.
  const Force spring = [](const Real& q, const Real&) -> Real { return -q; };
  const Phase x = moreau(spring, {1, 0}, 3, false);
  const Phase y = moreau(spring, {0, 1}, 3, false);
  const Real half_trace = (x.q + y.u) / 2;
  const Real radius = abs(half_trace) + sqrt(half_trace * half_trace - (x.q * y.u - x.u * y.q));
  // The positions of the midpoints obey Störmer's q_{M+1} − 2q_M + q_{M−1} = Δt² f(q_M).
  const Real dt = ratio(1, 10);
  Phase s = by_position.at(ratio(2, 5));
  std::vector<Real> middles;
  for (int k = 0; k < 12; ++k) {
    middles.push_back(s.q + dt / 2 * s.u);
    s = moreau(by_position.force, s, dt, false);
  }
  std::vector<Trial> trials;
  for (std::size_t k = 1; k + 1 < middles.size(); ++k) {
    trials.push_back(relative(dt * dt * by_position.force(middles[k], 0),
                              middles[k + 1] - 2 * middles[k] + middles[k - 1]));
  }
  const Trial stormer = worst(trials);
  return {
      relative(1, radius), stormer, digits50,
      "Oscillator at ωΔt = 3: Table 1 grows by " + text(radius, 4) +
          " a step (stable up to ωΔt = 2), the midpoint rule by 1. Its midpoints obey Störmer's recursion "
          "to " +
          text(stormer.error, 2) + "; the contact laws hold at t_E, not at t_M"};
}

Finding velocity_at_start() {
  const auto printed = [](Force f, const Phase& s, const Real& dt) { return moreau(f, s, dt, false); };
  const auto meant = [](Force f, const Phase& s, const Real& dt) { return moreau(f, s, dt, true); };
  const auto top_as = [](bool implicit) {
    return top_order(2, 250, [=](const State& s, double dt) { return moreau(s, dt, implicit); });
  };
  const Trial flight = top_as(false);
  const Trial both = line_order(by_both, 2, printed);
  const Trial velocity = line_order(by_velocity, 2, printed);
  const Trial top_meant = top_as(true);
  return {worst({flight, both, velocity}),
          worst({top_meant, line_order(by_both, 2, meant), line_order(by_velocity, 2, meant)}),
          measured_order,
          "Measured order of Table 1: tippe-top in free flight " + text(flight.obtained, 5) + ", q̈ = −2qq̇ " +
              text(both.obtained, 5) + ", q̈ = 1 − q̇² " + text(velocity.obtained, 5) +
              "; with (u_A + u_E)/2 for u_A the top has " + text(top_meant.obtained, 5) +
              ". A gyroscopic force turns u by an explicit Euler step: it grows by √(1 + Ω²Δt²) a step"};
}

Finding second_order() {
  const Trial t = line_order(by_position, 2,
                             [](Force f, const Phase& s, const Real& dt) { return moreau(f, s, dt, false); });
  return {t,
          {},
          measured_order,
          "M constant, h independent of the velocity (q̈ = 2q³ − 2q): measured order " + text(t.obtained, 6) +
              ". \"At best\" it is: see the row of h_M"};
}

Finding number_of_steps() {
  constexpr int n = 101;
  constexpr double end = 8;
  const double dt = end / (n - 1);
  const auto arrives = [&](int last) {
    double t = 0;
    for (int j = 1; j <= last; ++j) t += dt;
    return t;
  };
  return {relative(end, arrives(n)), relative(end, arrives(n - 1)), 1e-13,  // a hundred roundings
          "t_0 = 0, t_end = 8, N = 101: the loop ends at t = " + text(arrives(n)) +
              "; the fields have N entries, the steps between them are N − 1"};
}

Finding friction_indices() {
  int wrong = 0;
  int collisions = 0;
  for (int contacts = 1; contacts <= 6; ++contacts) {
    std::set<int> all;
    for (int chosen = 0; chosen < 1 << contacts; ++chosen) {
      std::set<int> set;
      std::set<int> with_closed_only;
      int closed = 0;
      for (int i = 1; i <= contacts; ++i) closed += (chosen >> (i - 1)) & 1;
      for (int i = 1; i <= contacts; ++i) {
        if (((chosen >> (i - 1)) & 1) == 0) continue;
        set.insert({2 * i - 1, 2 * i, i + 2 * contacts});
        with_closed_only.insert({2 * i - 1, 2 * i, i + 2 * closed});
      }
      if (set.size() != 3 * static_cast<std::size_t>(closed)) ++wrong;
      if (with_closed_only.size() != 3 * static_cast<std::size_t>(closed)) ++collisions;
      all.insert(set.begin(), set.end());
    }
    if (all.size() != 3 * static_cast<std::size_t>(contacts) || *all.rbegin() != 3 * contacts) ++wrong;
  }
  return {
      absolute(0, wrong),
      {},
      0,
      "All sets of closed contacts of up to six: three different numbers a contact, together 1 to 3n_C (" +
          text(wrong) + " fail), if n_C counts all contacts; with the closed ones only, " + text(collisions) +
          " sets collide. n_C is not defined"};
}

/// A block meets a floor at unit speed, Δt = 1, no other force: Table 1 from the gap g.
Phase land(Phase s) {
  const Real middle = s.q + s.u / 2;
  if (middle <= 0) s.u = std::max<Real>(s.u, 0);
  return {middle + s.u / 2, s.u};
}

Finding closed_at_midpoint() {
  Real deepest = 0;
  Real fastest = 0;
  for (int k = 0; k <= 100; ++k) {
    Phase s{ratio(k, 100), -1};
    for (int j = 0; j < 5; ++j) s = land(s);
    deepest = std::max<Real>(deepest, -s.q);
    fastest = std::max<Real>(fastest, abs(s.u));
  }
  return {absolute(0, deepest), at_most_zero(deepest - 1), digits50,
          "A block meets the floor at speed v from gaps of 0 to vΔt, Table 1: it comes to rest up to " +
              text(deepest, 3) + " vΔt below it (its speed then is " + text(fastest, 2) +
              "): a contact that closes after t_M is missed for one step, and nothing lifts it again"};
}

// (4.20) and its array.

using Array = std::array<std::array<Rational, 4>, 4>;
const std::array<Rational, 4> weights{Rational(1, 6), Rational(1, 3), Rational(1, 3), Rational(1, 6)};
const std::array<Rational, 4> nodes{0, Rational(1, 2), Rational(1, 2), 1};
Array array() {
  Array a{};
  a[1][0] = a[2][1] = Rational(1, 2);
  a[3][2] = 1;
  return a;
}

Finding generic_scheme() {
  // ẋ = x cos t, x = exp(sin t), exactly as (4.20) is written.
  const Trial t = order(
      [](const Real& argument) -> Real {
        const int count = static_cast<int>(round(10 / argument));
        const Real dt = Real(1) / count;
        const auto f = [](const Real& time, const Real& x) -> Real { return x * cos(time); };
        const Array a = array();
        Real x = 1;
        for (int n = 0; n < count; ++n) {
          std::array<Real, 4> slope;
          for (std::size_t i = 0; i < 4; ++i) {
            Real stage = x;
            for (std::size_t j = 0; j < i; ++j) stage += dt * Real(a[i][j]) * slope[j];
            slope[i] = f(n * dt + Real(nodes[i]) * dt, stage);
          }
          for (std::size_t i = 0; i < 4; ++i) x += dt * Real(weights[i]) * slope[i];
        }
        return x - exp(sin(Real(1)));
      },
      4);
  return {
      t, {}, measured_order, "ẋ = x cos t with the array below it: measured order " + text(t.obtained, 6)};
}

Finding order_conditions() {
  const Array a = array();
  const auto apply = [&](const std::array<Rational, 4>& x) {
    std::array<Rational, 4> y{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) y[i] += a[i][j] * x[j];
    }
    return y;
  };
  const auto times = [](std::array<Rational, 4> x, const std::array<Rational, 4>& y) {
    for (std::size_t i = 0; i < 4; ++i) x[i] *= y[i];
    return x;
  };
  const auto sum = [&](const std::array<Rational, 4>& x) {
    Rational s = 0;
    for (std::size_t i = 0; i < 4; ++i) s += weights[i] * x[i];
    return s;
  };
  const std::array<Rational, 4> one{1, 1, 1, 1};
  const auto& c = nodes;
  int wrong = apply(one) == c ? 0 : 1;
  const std::vector<std::pair<Rational, int>> trees{
      {sum(one), 1},
      {sum(c), 2},
      {sum(times(c, c)), 3},
      {sum(apply(c)), 6},
      {sum(times(c, times(c, c))), 4},
      {sum(times(c, apply(c))), 8},
      {sum(apply(times(c, c))), 12},
      {sum(apply(apply(c))), 24},
  };
  for (const auto& [value, density] : trees) wrong += value == Rational(1, density) ? 0 : 1;
  const bool fifth = sum(apply(apply(apply(c)))) == Rational(1, 120);
  return {absolute(0, wrong + (fifth ? 1 : 0)),
          {},
          0,
          "c = A1 and the eight order conditions up to four in rational numbers: " + text(wrong) +
              " fail; of order five b·AAAc = 1/120 already fails (it is 0)"};
}

Finding table2_is_the_array() {
  // Table 2 with exact accelerations against (4.20) for (q, u), one step of q̈ = −2qq̇.
  const Force f = by_both.force;
  const Real dt = ratio(1, 5);
  const Phase start = by_both.at(ratio(2, 5));
  const Phase end = table2(f, start, dt, stage_meant);
  const Array a = array();
  std::array<Phase, 4> slope;
  Phase direct = start;
  for (std::size_t i = 0; i < 4; ++i) {
    Phase x = start;
    for (std::size_t j = 0; j < i; ++j) {
      x.q += dt * Real(a[i][j]) * slope[j].q;
      x.u += dt * Real(a[i][j]) * slope[j].u;
    }
    slope[i] = {x.u, f(x.q, x.u)};
    direct.q += dt * Real(weights[i]) * slope[i].q;
    direct.u += dt * Real(weights[i]) * slope[i].u;
  }
  const Trial t = worst({relative(direct.q, end.q), relative(direct.u, end.u)});
  return {
      t,
      {},
      digits50,
      "With exact accelerations a_m the stages and sums of Table 2 are (4.20) for (q, u) with that array, "
      "to " +
          text(t.error, 2)};
}

Finding table2_order() {
  const auto with = [](auto stage) {
    return [=](Force f, const Phase& s, const Real& dt) { return table2(f, s, dt, stage); };
  };
  const Trial position = line_order(by_position, 4, with(stage_printed));
  const Trial both = line_order(by_both, 4, with(stage_printed));
  const Trial velocity = line_order(by_velocity, 4, with(stage_printed));
  const auto flown = [](bool displaced) {
    return [=](const State& s, double dt) { return runge_kutta(s, dt, displaced); };
  };
  const Trial flight = top_order(4, 250, flown(true));
  std::vector<Trial> meant{top_order(4, 10, flown(false))};
  for (const Line& line : {by_position, by_velocity, by_both})
    meant.push_back(line_order(line, 4, with(stage_meant)));
  // An oscillator, ω = 1: the area of a step is e^{−2·damping·Δt}.
  const Force spring = [](const Real& q, const Real&) -> Real { return -q; };
  const Real dt = ratio(1, 10000);
  const Phase x = table2(spring, {1, 0}, dt, stage_printed);
  const Phase y = table2(spring, {0, 1}, dt, stage_printed);
  const Real damping = -log(x.q * y.u - x.u * y.q) / (2 * dt * dt);
  return {worst({position, both, flight}), worst(meant),
          5 * measured_order,  // of the top in ten steps: log10(1 + O(0.025)), rounding 1e-13 of 1e-10

          "Measured order: q̈ = 2q³ − 2q " + text(position.obtained, 5) + ", q̈ = −2qq̇ " +
              text(both.obtained, 5) + ", tippe-top in free flight " + text(flight.obtained, 5) +
              "; only q̈ = 1 − q̇², which knows neither t nor q, has " + text(velocity.obtained, 5) +
              ". a_m = M⁻¹h at (t_m + Δt2/2, q_m + u_mΔt2/2, u_m): off by (Δt/8) d/dt along u, however exact "
              "the weights. An oscillator loses amplitude at the rate " +
              text(damping, 5) + " ω²Δt (1/16). With M, h at (t_m, q_m, u_m) the top has " +
              text(meant.front().obtained, 4)};
}

/// Table 2 for a block of unit mass above a floor, no other force than the floor's, Δt = 1; Δt2 as a part of
/// it.
Phase table2_block(const Phase& start, const Real& part) {
  return table2(nullptr, start, 1, [&](Force, const Phase& x, const Real&) -> Real {
    const bool closed = x.q + part / 2 * x.u <= 0;
    return closed && x.u < 0 ? Real(-x.u / part) : Real(0);
  });
}

/// The speed at which the block leaves after falling on the floor at speed 1.
Real leaves(Phase s) {
  for (int j = 0; j < 50; ++j) s = table2_block(s, ratio(1, 4));
  return s.u;
}

Finding impact_in_stages() {
  Real most = 0;
  Real least = 1;
  Real moreaus = 0;
  for (int k = 0; k <= 100; ++k) {
    const Phase falls{ratio(k, 100), -1};
    const Real speed = leaves(falls);
    most = std::max<Real>(most, speed);
    least = std::min<Real>(least, speed);
    Phase s = falls;
    for (int j = 0; j < 5; ++j) s = land(s);
    moreaus = std::max<Real>(moreaus, abs(s.u));
  }
  const Real all = leaves({-1, -1});
  return {
      absolute(0, most), absolute(0, moreaus), digits50,
      "A block meets the floor at speed 1, ε_N = 0, gaps of 0 to 1 (Δt = 1) at the start of the step, Table "
      "2: it leaves at " +
          text(least, 4) + " to " + text(most, 4) + ", and at " + text(all, 4) +
          " where all stages see the floor: each a_m is the whole impulse over Δt/4, their mean is not one "
          "impulse. With Table 1: " +
          text(moreaus, 2)};
}

Finding sticking_in_stages() {
  // A sticking contact: every stage brings u to zero within Δt2. What a step of Table 2 leaves of u = 1.
  const auto left = [](const Real& part) -> Real {
    return table2(nullptr, {0, 1}, 1, [&](Force, const Phase& x, const Real&) -> Real { return -x.u / part; })
        .u;
  };
  Real smallest = 1;
  for (int k = 1; k <= 400; ++k) smallest = std::min<Real>(smallest, abs(left(ratio(100, k))));
  const Real printed = left(ratio(1, 4));
  const Real half = left(ratio(1, 2));
  const Real edge = left(Real(1) / Real("2.785"));
  // Friction limit 1, pushed with 1/2, disturbed by a last digit: the largest speed between step 100 and 200.
  const auto stage = [](Force, const Phase& x, const Real&) -> Real {
    const Real push = ratio(1, 2);
    const Real needed = -4 * x.u - push;
    return std::clamp<Real>(needed, -1, 1) + push;
  };
  Phase pushed{0, Real(1e-16)};
  Real fastest = 0;
  for (int k = 0; k < 200; ++k) {
    pushed = table2(nullptr, pushed, 1, stage);
    if (k >= 100) fastest = std::max<Real>(fastest, abs(pushed.u));
  }
  return {
      at_most_zero(abs(printed) - 1), worst({at_most_zero(abs(half) - 1), at_most_zero(edge - 1)}), digits50,
      "A sticking contact, u̇ = −u/Δt2 to every stage: a step of Table 2 multiplies u by 1 + z + z²/2 + "
      "z³/6 + z⁴/24, z = −Δt/Δt2: " +
          text(printed, 4) + " for Δt/4, " + text(half, 4) + " for Δt/2. On the whole line it is at least " +
          text(smallest, 3) +
          ": no Δt2 makes a contact stick in one step. A block pushed with half its friction limit F moves, "
          "from a disturbance of 1e-16 on, at up to " +
          text(fastest, 3) + " FΔt/m"};
}

/// The velocity of a block that falls under unit weight and lands at t = 1, ε_N = 0, and its mean over a
/// step.
Real falling(const Real& t) { return t < 1 ? Real(-t) : Real(0); }

Finding unbounded_variation() {
  const Trial t = order(
      [](const Real& dt) -> Real {
        // Mean accelerations on a grid with the impact inside a step.
        Real variation = 0;
        Real before = -1;
        for (Real start = 1 - ratio(21, 2) * dt; start < 1 + 10 * dt; start += dt) {
          const Real mean = (falling(start + dt) - falling(start)) / dt;
          variation += abs(mean - before);
          before = mean;
        }
        // The jump of the velocity, up and down, over Δt; the rest is bounded by the weight.
        return variation;
      },
      -1);
  return {
      t,
      {},
      2 * order_bound,  // weight over jump/Δt: log10(1 + O(1e-2))
      "A block that falls and lands: the variation of (u(t + Δt) − u(t))/Δt over the impact grows with the "
      "power " +
          text(t.obtained, 5) + " of Δt. The density u̇ of du is of bounded variation, but misses the jump"};
}

Finding pseudo_acceleration() {
  std::vector<Trial> trials;
  const Real dt = ratio(1, 10);
  for (int k = 0; k < 20; ++k) {
    const Real from = k * dt - ratio(1, 30);
    const Real to = from + dt;
    // ∫du: weight while it falls, and the atom at t = 1.
    const Real falls = std::max<Real>(0, std::min<Real>(to, 1) - std::min<Real>(from, 1));
    const Real measure = -falls + (from < 1 && to >= 1 ? 1 : 0);
    trials.push_back(absolute(measure / dt, (falling(to) - falling(from)) / dt));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "The landing block, 20 steps of which one holds the impact: (u^j − u^{j−1})/Δt against ∫du/Δt, "
          "density and atom: difference " +
              text(t.error, 2) + ". It is an average at every Δt, and of order 1/Δt in an impact"};
}

}  // namespace

std::vector<Row> section4_2() {
  return {
      {"4.18", "(4.18)", "M_M(u_E − u_A) = h_MΔt + W_NM Λ_N + W_FM Λ_F", Flaw::none, "",
       "If h_M is taken at the midpoint in all its arguments; Table 1 does not.", midpoint_equation},
      {"4.18.trapezoid", "Section 4.2, before (4.18)", "u_E is calculated by a trapezoidal scheme",
       Flaw::imprecise, "with the matrices of the midpoint; the positions by the trapezoidal rule", "",
       trapezoidal_rule},
      {"4.19", "(4.19)", "−Λ_N ∈ ∂Ψ_{R+}(γ_N⁺), −Λ_F ∈ ∂Φ(γ_F⁺)", Flaw::none, "",
       "γ⁺ is the velocity u_E in the directions of the midpoint.", step_laws},
      {"4.20", "(4.20)",
       "X_i = x_n + Δt Σ_{j<i} a_ij f(t_n + c_jΔt, X_j), x_{n+1} = x_n + Δt Σ b_i f(t_n + "
       "c_iΔt, X_i)",
       Flaw::none, "", "", generic_scheme},
      {"s4.2.midpoint", "Section 4.2, Moreau's method", "basically a special kind of midpoint DAE solver",
       Flaw::imprecise,
       "Störmer's scheme for the midpoints' positions (M constant, h(t, q)); the force laws hold at t_E",
       "It is explicit where nothing touches, with Störmer's bound ωΔt <= 2 on the step.", midpoint_solver},
      {"s4.2.closed", "Section 4.2, I_N", "The set I_N contains all indices of the closed contact points",
       Flaw::imprecise,
       "those whose gap is closed at the predicted midpoint; penetration up to |γ_N⁻|Δt remains",
       "Gaps of closed contacts are not zero but negative, of first order in the step.", closed_at_midpoint},
      {"t1.steps", "Tables 1 and 2, loop", "Δt = (t_end − t_0)/(N − 1), for j = 1 to N", Flaw::misprint,
       "for j = 1 to N − 1", "As printed the result ends at t_end + Δt.", number_of_steps},
      {"t1.h", "Table 1, h_M", "h_M = h(t_M, q_M, u_A), for the system matrices evaluated at the midpoint",
       Flaw::imprecise, "h(t_M, q_M, (u_A + u_E)/2), an implicit equation",
       "Table 1 is of first order wherever forces depend on the velocity, as the gyroscopic ones of the top.",
       velocity_at_start},
      {"t1.indices", "Tables 1 and 2, I_F", "I_F = {2i − 1} ∪ {2i} ∪ {i + 2n_C}, i ∈ I_N", Flaw::none, "",
       "All tangential forces come first, then the torques: not the order of (2.21) for each contact.",
       friction_indices},
      {"s4.2.second", "Section 4.2, order of Moreau's method", "it is at best a second-order method",
       Flaw::none, "", "", second_order},
      {"s4.2.require",
       "Section 4.2, high frequencies",
       "high frequency oscillations, which require a higher-order integration scheme",
       Flaw::not_checkable,
       "",
       "",
       {},
       "What is required depends on the accuracy asked for; none is named."},
      {"s4.2.array", "Section 4.2, Butcher array",
       "c = (0, 1/2, 1/2, 1), b = (1/6, 1/3, 1/3, 1/6): a fourth-order integration method for ordinary "
       "differential equations",
       Flaw::none, "", "", order_conditions},
      {"s4.2.variation", "Section 4.2, accelerations",
       "accelerations and contact forces are not functions of bounded variation if an impact occurs",
       Flaw::none, "", "", unbounded_variation},
      {"s4.2.pseudo", "Section 4.2, pseudo-acceleration",
       "an average acceleration per time-step a^j = (u^j − u^{j−1})/Δt", Flaw::none, "", "",
       pseudo_acceleration},
      {"t2.array", "Table 2, stages", "the classical Runge–Kutta method for (q, u)", Flaw::none, "",
       "q_E of ComputeStage is never used.", table2_is_the_array},
      {"t2.order", "Table 2, ComputeStage",
       "a_m = (u_E − u_A)/Δt2 of a step of Moreau for the acceleration of a fourth-order scheme", Flaw::wrong,
       "M⁻¹h at (t_m, q_m, u_m)",
       "Table 2 is of first order in smooth motion, too; it damps an oscillation at the rate ω²Δt/16.",
       table2_order},
      {"t2.dt2", "Table 2, Δt2",
       "a Runge–Kutta method for systems with impact and friction, its pseudo-accelerations over Δt2 = Δt/4",
       Flaw::wrong, "Δt2 > Δt/2.785 at the least",
       "With Δt2 = Δt/4 what is left of the sliding velocity in a sticking contact grows fivefold a step "
       "until it slips, and never dies out.",
       sticking_in_stages},
      {"t2.impact", "Table 2, impact", "the law (4.19) of a completely inelastic impact in every stage",
       Flaw::wrong, "(4.19) over the whole step, as in Table 1",
       "As printed the scheme rebounds; where all stages see the impact, with the full speed.",
       impact_in_stages},
      {"s4.2.half-explicit",
       "Section 4.2, half-explicit methods",
       "closely related to half-explicit Runge–Kutta methods for differential algebraic equations",
       Flaw::not_checkable,
       "",
       "",
       {},
       "\"Closely related\" names no property. Half-explicit methods fulfil the constraint at the next "
       "stage, "
       "Table 2 after Δt2 from each stage: see the row of Δt2."},
  };
}

}  // namespace verify::ledger
