// LG03 Section 2: uniform pressure, (2.1) to (2.21).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "elimination.hpp"
#include "oracle.hpp"

namespace verify::ledger {
namespace {

constexpr Pressure uniform = Pressure::uniform;

/// μλ_N|ω|R f(u) of the oracle, in the contact's units.
Real exact_potential(const Contact& c) {
  return Real(c.mu) * c.lambda_n * std::abs(c.omega) * c.radius *
         exact(uniform, Real(std::abs(c.v)) / (std::abs(c.omega) * c.radius)).f;
}

// The series as printed.
Real potential_inner(const Real& u) { return ratio(2, 3) + u * u / 2 - pow(u, 4) / 32 - pow(u, 6) / 384; }
Real potential_outer(const Real& w) { return 1 / w + w / 8 + pow(w, 3) / 192 + pow(w, 5) / 1024; }
Real force_inner(const Real& u) { return u - pow(u, 3) / 8 - pow(u, 5) / 64; }
Real force_outer(const Real& w) { return 1 - w * w / 8 - pow(w, 4) / 64 - 5 * pow(w, 6) / 1024; }
Real torque_inner(const Real& u) {
  return ratio(2, 3) - u * u / 2 + 3 * pow(u, 4) / 32 + 5 * pow(u, 6) / 384;
}
Real torque_outer(const Real& w) { return w / 4 + pow(w, 3) / 48 + 3 * pow(w, 5) / 512; }
Real plate_inner_printed(const Real& xi, const Real& eta) {
  return ratio(9, 4) * eta * eta + ratio(3, 2) * xi * xi - ratio(15, 32) * pow(xi, 4) -
         ratio(5, 128) * pow(xi, 6);
}
Real plate_outer_printed(const Real& xi, const Real& eta) {
  return xi * xi + 4 * eta * eta - ratio(20, 3) * pow(eta, 4) + ratio(40, 9) * pow(eta, 6);
}

/// ∫_0^{2π} √(x² + 1 − 2x sin φ) dφ, by halves: the integrand is symmetric about φ = π/2.
Real ring(const Real& x) {
  return 2 *
         integrate([&](const Real& phi) { return sqrt(x * x + 1 - 2 * x * sin(phi)); }, -pi() / 2, pi() / 2);
}

/// The local law integrated: force along e_1 and torque,
/// as they act against the motion (positive for v, ω > 0).
struct Resultant {
  double force;
  double torque;
};
Resultant resultant(Pressure pressure, const Contact& c) {
  const auto traction = [&](double rho, double phi, auto component) {
    const double w1 = c.v - c.omega * rho * std::sin(phi);
    const double w2 = c.omega * rho * std::cos(phi);
    const double w = std::hypot(w1, w2);
    return w == 0 ? 0.0 : c.mu * pressure_at(pressure, c, rho) * component(w1 / w, w2 / w, rho, phi);
  };
  return {over_disc(c,
                    [&](double rho, double phi) {
                      return traction(rho, phi, [](double t1, double, double, double) { return t1; });
                    }),
          over_disc(c, [&](double rho, double phi) {
            return traction(rho, phi, [](double t1, double t2, double r, double p) {
              return r * (std::cos(p) * t2 - std::sin(p) * t1);
            });
          })};
}

/// Five-point central difference of Φ in one member of the contact.
double slope(Pressure pressure, Contact c, double Contact::*member) {
  const double centre = c.*member;
  const double h = 1e-3 * std::abs(centre);
  const auto at = [&](int k) {
    c.*member = centre + k * h;
    return potential_by_definition(pressure, c);
  };
  return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
}

Finding definition() {
  std::vector<Trial> trials;
  for (const Pressure pressure : {Pressure::uniform, Pressure::hertz}) {
    for (const Contact& c : contacts()) {
      const auto [force, torque] = resultant(pressure, c);
      trials.push_back(relative(force, slope(pressure, c, &Contact::v)));
      trials.push_back(relative(torque, slope(pressure, c, &Contact::omega)));
    }
  }
  const Trial t = worst(trials);
  return {t,
          {},
          differenced,
          "Force and torque of local Coulomb friction, integrated over the disc, against the slopes of (2.1) "
          "in v and ω: 20 "
          "contacts (both pressures, all signs), largest relative difference " +
              text(t.error, 3)};
}

Finding polar_integral() {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) {
    const double integral = over_disc(c, [&](double rho, double phi) {
      return std::sqrt(
          std::max(0.0, c.v * c.v + std::pow(c.omega * rho, 2) - 2 * c.omega * rho * c.v * std::sin(phi)));
    });
    trials.push_back(relative(exact_potential(c),
                              c.mu * c.lambda_n / (std::numbers::pi * c.radius * c.radius) * integral));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          nested,
          "Double integral as printed against the chord integrals in 50 digits, 10 contacts of either sign, "
          "u = 0.20 to 1.43: largest "
          "relative difference " +
              text(t.error, 3)};
}

Finding auxiliary_variables() {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) {
    const double critical = std::abs(c.v / c.omega);
    const double rho = critical / 3;
    trials.push_back(relative(c.omega * rho / c.v, 1 / (c.v / (c.omega * rho))));
    trials.push_back(relative(1, std::abs(c.v / (c.omega * critical))));
  }
  const Trial t = worst(trials);
  return {t, {}, 1e-15, "β = 1/α and |α(R*)| = 1 for 10 contacts, to " + text(t.error, 2)};
}

/// (2.4) in the contact's own signs.
double split_integral(const Contact& c) {
  const double half_pi = std::numbers::pi / 2;
  const double critical = std::abs(c.v / c.omega);
  const auto around = [&](double x) {
    const auto g = [&](double phi) { return std::sqrt(std::max(0.0, x * x + 1 - 2 * x * std::sin(phi))); };
    return integrate_double(g, -half_pi, half_pi) + integrate_double(g, half_pi, 3 * half_pi);
  };
  const double fast = integrate_double(
      [&](double rho) { return std::abs(c.omega) * rho * rho * around(c.v / (c.omega * rho)); }, critical,
      c.radius);
  const double slow = integrate_double(
      [&](double rho) { return std::abs(c.v) * rho * around(c.omega * rho / c.v); }, 0, critical);
  return c.mu * c.lambda_n / (std::numbers::pi * c.radius * c.radius) * (fast + slow);
}

Finding split() {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) {
    if (c.u() < 1) trials.push_back(relative(exact_potential(c), split_integral(c)));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          nested,
          "Both integrals as printed, u = 0.20 and 0.64, all signs of v and ω: largest relative difference " +
              text(t.error, 3)};
}

Finding alpha_sign() {
  Contact c;
  c.omega = -c.omega;
  const double rho = std::abs(c.v / c.omega) / 2;  // inside R*: the second integral
  const double alpha = c.v / (c.omega * rho);
  return {at_most_zero(1 - alpha), at_most_zero(1 - std::abs(alpha)), 0,
          "v = 1.3, ω = −2.9, ρ = R*/2: α = " + text(alpha) + ", not > 1; |α| = " + text(std::abs(alpha))};
}

Finding ring_series() {
  const Function remainder = [](const Real& x) -> Real {
    return ring(x) / pi() - (2 + x * x / 2 + pow(x, 4) / 32 + pow(x, 6) / 128);
  };
  const Trial t = order(remainder, 8);
  const Real x = ratio(1, 1000);
  PowerSeries squares;
  for (unsigned k = 0; k < 6; ++k)
    squares.push_back(2 * binomial(Rational(1, 2), k) * binomial(Rational(1, 2), k));
  return {t,
          {},
          order_bound,
          "Remainder of the printed sum falls with power " + text(t.obtained) +
              " of x; its leading coefficient " + text(remainder(x) / pow(x, 8), 8) + " is 25/8192 = " +
              text(ratio(25, 8192), 8) + ". All coefficients are 2 C(1/2,k)²: " + text(squares) +
              ". At the worst place, x = 1, the sum gives " + text(pi() * ratio(325, 128), 7) +
              " instead of 8"};
}

Finding ring_range() {
  const auto sum = [](const Real& x) {
    Real s = 0;
    Real c = 1;
    for (int k = 0; k < 400; ++k) {
      s += 2 * c * c * pow(x, 2 * k);
      c *= (ratio(1, 2) - k) / (k + 1);
    }
    return Real(pi() * s);
  };
  const Real far = ratio(-3, 2);
  const Real near = ratio(-9, 10);
  return {relative(ring(far), sum(far)), relative(ring(near), sum(near)), 1e-30,
          "400 terms: at x = −1.5 (< 1) " + text(sum(far), 3) + " instead of " + text(ring(far)) +
              "; at x = −0.9 " + text(sum(near)) + ", relative error " +
              text(relative(ring(near), sum(near)).error, 2)};
}

/// The four lines of (2.6) for a contact with R* < R; `cube` is v³ or |v|³ in the last term.
std::array<Real, 4> lines_of_potential(const Contact& contact, bool magnitude) {
  const Real v = contact.v;
  const Real omega = contact.omega;
  const Real radius = contact.radius;
  const Real critical = abs(v / omega);
  const Real scale = Real(contact.mu) * contact.lambda_n;
  const auto series = [](const Real& x) -> Real { return 2 + x * x / 2 + pow(x, 4) / 32 + pow(x, 6) / 128; };
  const Real s2 = v * v / (omega * omega);
  const Real line1 =
      integrate([&](const Real& rho) { return abs(omega) * rho * rho * series(v / (omega * rho)); }, critical,
                radius) +
      integrate([&](const Real& rho) { return abs(v) * rho * series(omega * rho / v); }, 0, critical);
  const Real line2 = integrate(
                         [&](const Real& rho) {
                           return abs(omega) * (2 * rho * rho + s2 / 2 + s2 * s2 / 32 / (rho * rho) +
                                                pow(s2, 3) / 128 / pow(rho, 4));
                         },
                         critical, radius) +
                     integrate(
                         [&](const Real& rho) {
                           return abs(v) * (2 * rho + pow(rho, 3) / s2 / 2 + pow(rho, 5) / (s2 * s2) / 32 +
                                            pow(rho, 7) / pow(s2, 3) / 128);
                         },
                         0, critical);
  const auto outside = [&](const Real& rho) -> Real {
    return 2 * pow(rho, 3) / 3 + s2 * rho / 2 - s2 * s2 / (32 * rho) - pow(s2, 3) / (384 * pow(rho, 3));
  };
  const auto inside = [&](const Real& rho) -> Real {
    return rho * rho + pow(rho, 4) / (8 * s2) + pow(rho, 6) / (192 * s2 * s2) +
           pow(rho, 8) / (1024 * pow(s2, 3));
  };
  const Real line3 = abs(omega) * (outside(radius) - outside(critical)) + abs(v) * inside(critical);
  const Real u = v / (omega * radius);
  const Real cube = magnitude ? Real(pow(abs(v), 3)) : Real(v * v * v);
  const Real line4 = scale * abs(omega) * radius * potential_inner(u) -
                     scale * ratio(5, 3072) * cube / pow(omega * radius, 2);
  const Real front = scale / (radius * radius);
  return {front * line1, front * line2, front * line3, line4};
}

Finding truncated_potential() {
  std::vector<Trial> trials;
  for (const Contact& c : positive_contacts()) {
    if (c.u() >= 1) continue;
    const auto lines = lines_of_potential(c, false);
    for (std::size_t i = 1; i < lines.size(); ++i) trials.push_back(relative(lines[0], lines[i]));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "Lines 2, 3, 4 (with the last term) against line 1, v > 0, R* < R: largest relative difference " +
              text(t.error, 3)};
}

/// One line of (2.6) alone, against the line before it.
Finding truncated_potential_line(std::size_t line) {
  std::vector<Trial> trials;
  for (const Contact& c : positive_contacts()) {
    if (c.u() >= 1) continue;
    const auto lines = lines_of_potential(c, false);
    trials.push_back(relative(lines[line - 2], lines[line - 1]));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "Against the line before it, v > 0, R* < R: largest relative difference " + text(t.error, 2)};
}

/// Line 1 is (2.4) with the truncated ring: what is lost, relative
/// to Φ, is no more than (2.5) loses at its worst, x = 1.
Finding truncated_potential_first_line() {
  std::vector<Trial> trials;
  for (const Contact& c : positive_contacts()) {
    if (c.u() < 1) trials.push_back(relative(exact_potential(c), lines_of_potential(c, false)[0]));
  }
  const Trial t = worst(trials);
  const double ring_error = static_cast<double>(1 - pi() * ratio(325, 128) / 8);
  return {t,
          {},
          ring_error,
          "Relative error against Φ up to " + text(t.error, 3) + "; (2.5) loses " + text(ring_error, 3) +
              " at x = 1"};
}

Finding last_term() {
  Contact c;
  c.v = -c.v;
  const auto printed = lines_of_potential(c, false);
  const auto corrected = lines_of_potential(c, true);
  return {relative(printed[0], printed[3]), relative(corrected[0], corrected[3]), digits50,
          "v = −1.3: with v³ relative error " + text(relative(printed[0], printed[3]).error, 3) +
              ", with |v|³ " + text(relative(corrected[0], corrected[3]).error, 2) +
              ". Coefficient: (1 + 1/8 + 1/192 + 1/1024) − (2/3 + 1/2 − 1/32 − 1/384) = −5/3072"};
}

/// The seam term after `count` terms of (2.5): Σ a_k (1/(2k+2) + 1/(2k−3)), a_k = 2 C(1/2,k)².
template <class Number>
Number seam_term(int count) {
  Number sum = 0;
  Number c = 1;
  for (int k = 0; k < count; ++k) {
    sum += 2 * c * c * (Number(1) / (2 * k + 2) + Number(1) / (2 * k - 3));
    c *= (Number(1) / 2 - k) / (k + 1);
  }
  return sum;
}

Finding last_term_vanishes() {
  // a_k ~ 1/(2πk³), so the tail of the (vanishing) infinite sum is 1/(6πN³) (1 + O(1/N)), the O within 5/N.
  const int count = 1000;
  const Real scaled = -seam_term<Real>(count) * 6 * pi() * count * count * count;
  const Rational four = seam_term<Rational>(4);
  std::vector<Trial> trials{relative(1, scaled), relative(1, Real(four / Rational(-5, 3072)))};
  return {worst(trials),
          {},
          0.005,
          "Coefficient for 2, 3, 4, 5, 10 terms of (2.5): " + seam_term<Rational>(2).str() + ", " +
              seam_term<Rational>(3).str() + ", " + four.str() + ", " + seam_term<Rational>(5).str() + ", " +
              text(seam_term<Real>(10), 3) + "; for 1000 terms " + text(seam_term<Real>(count), 4) +
              ", which is −1/(6πN³) times " + text(scaled)};
}

Finding slow_spin_integral() {
  std::vector<Trial> trials;
  const double half_pi = std::numbers::pi / 2;
  for (const Contact& c : contacts()) {
    if (c.u() <= 1) continue;
    const double integral = integrate_double(
        [&](double rho) {
          const double beta = c.omega * rho / c.v;
          const auto g = [&](double phi) {
            return std::sqrt(std::max(0.0, beta * beta + 1 - 2 * beta * std::sin(phi)));
          };
          return std::abs(c.v) * rho *
                 (integrate_double(g, -half_pi, half_pi) + integrate_double(g, half_pi, 3 * half_pi));
        },
        0, c.radius);
    trials.push_back(relative(exact_potential(c),
                              c.mu * c.lambda_n / (std::numbers::pi * c.radius * c.radius) * integral));
  }
  const Trial t = worst(trials);
  return {t, {}, nested, "As printed, u = 1.43, all signs: largest relative difference " + text(t.error, 3)};
}

Finding potential_orders() {
  const Trial inner = order([](const Real& u) { return Real(exact(uniform, u).f - potential_inner(u)); }, 8);
  const Trial outer =
      order([](const Real& w) { return Real(exact(uniform, 1 / w).f - potential_outer(w)); }, 7);
  const Real at_one = 32 / (9 * pi());
  return {worst({inner, outer}),
          {},
          order_bound,
          "Remainders fall with the powers " + text(inner.obtained) + " of u and " + text(outer.obtained) +
              " of 1/u. Exact coefficients (u², u⁴, ...: " + text(potential_series(uniform_inner(5), true)) +
              "; u, 1/u, ...: " + text(potential_series(uniform_outer(5), false)) +
              "). Worst at u = 1: " + text(potential_inner(1)) + " and " + text(potential_outer(1)) +
              ", exact 32/(9π) = " + text(at_one)};
}

Finding potential_orders_over_v() {
  const Trial inner = order(
      [](const Real& u) -> Real {
        return exact(uniform, u).f / u - (ratio(2, 3) / u + u / 2 - pow(u, 3) / 32 - pow(u, 5) / 384);
      },
      7);
  const Trial outer = order(
      [](const Real& w) -> Real {
        return exact(uniform, 1 / w).f * w - (1 + w * w / 8 + pow(w, 4) / 192 + pow(w, 6) / 1024);
      },
      8);
  return {worst({inner, outer}),
          {},
          order_bound,
          "Remainders fall with the powers " + text(inner.obtained) + " of u and " + text(outer.obtained) +
              " of 1/u"};
}

Finding pure_motions() {
  Contact sliding;
  sliding.omega = 0;
  Contact spinning;
  spinning.v = 0;
  const Trial slide =
      relative(sliding.mu * sliding.lambda_n * sliding.v, potential_by_definition(uniform, sliding));
  const Trial spin =
      relative(Real(2) / 3 * spinning.mu * spinning.lambda_n * spinning.omega * spinning.radius,
               potential_by_definition(uniform, spinning));
  return {worst({slide, spin}),
          {},
          nested,
          "Definition (2.1) at ω = 0 and at v = 0: relative differences " + text(slide.error, 2) + ", " +
              text(spin.error, 2)};
}

/// Along (λ_T, λ_τ) = t (1, 2/3) μλ_N, the corner of disk ×
/// interval: how far the joint subdifferential at γ_F = 0 reaches.
Finding subdifferential_at_rest() {
  const Real corner = ratio(2, 3);
  // λ ∈ ∂Φ(0) means λ·γ <= Φ(γ) for every γ: here t (u + 2/3) <=
  // f(u) for all u, by brute force over directions tan ψ = u.
  Real reach = 1;
  const int directions = 50;
  for (int i = 1; i < directions; ++i) {
    const Real u = tan(pi() / 2 * i / directions);
    reach = std::min(reach, Real(exact(uniform, u).f / (u + corner)));
  }
  // Where the border of the ball, (ξ(u), η(u)), crosses the ray.
  Real low = 0;
  Real high = 2;
  for (int i = 0; i < 60; ++i) {
    const Real u = (low + high) / 2;
    const Exact e = exact(uniform, u);
    (corner * e.xi < e.eta ? low : high) = u;
  }
  const Real border = exact(uniform, low).xi;
  // A step of π/100 about the minimum of a function with curvature below one.
  const double bound = std::pow(std::numbers::pi / (2 * directions), 2);
  return {relative(border, 1), relative(border, reach), bound,
          "At γ_F = 0 the separate conditions are ‖λ_T‖ <= μλ_N and |λ_τ| <= (2/3)μλ_N: (λ_T, λ_τ) = (1, "
          "2/3)μλ_N passes both. "
          "λ·γ <= Φ(γ) for all γ lets only " +
              text(reach) + " of it pass; the border of B_F crosses that ray at " + text(border)};
}

Finding chain_rule() {
  std::vector<Trial> off_rest;
  for (const Contact& c : contacts()) {
    const auto [force, torque] = resultant(uniform, c);
    const Exact e = exact(uniform, Real(std::abs(c.v)) / (std::abs(c.omega) * c.radius));
    // signs: ∂‖γ_T‖ = γ_T/‖γ_T‖, ∂|ω| = sgn ω
    off_rest.push_back(relative(std::copysign(1.0, c.v) * c.mu * c.lambda_n * e.xi, force));
    off_rest.push_back(relative(std::copysign(1.0, c.omega) * c.mu * c.lambda_n * c.radius * e.eta, torque));
  }
  const Real along_spin = exact(uniform, ratio(1, 1000000)).xi;
  const Real along_slide = exact(uniform, 1000000).xi;
  const Trial corrected = worst(off_rest);
  return {absolute(along_spin, along_slide), corrected, nested,
          "∇_{|v|}Φ/(μλ_N) at the origin is " + text(along_spin, 3) + " along v/(ωR) = 1e-6 and " +
              text(along_slide, 12) +
              " along v/(ωR) = 1e6: no gradient there. Off the origin force and torque agree to " +
              text(corrected.error, 2)};
}

Finding force_orders() {
  const Trial inner = order([](const Real& u) { return Real(exact(uniform, u).xi - force_inner(u)); }, 7);
  const Trial outer = order([](const Real& w) { return Real(exact(uniform, 1 / w).xi - force_outer(w)); }, 8);
  return {worst({inner, outer}),
          {},
          order_bound,
          "Remainders fall with the powers " + text(inner.obtained) + " of u and " + text(outer.obtained) +
              " of 1/u. At u = 1: " + text(force_inner(1), 7) + " and " + text(force_outer(1), 7) +
              ", exact 8/(3π) = " + text(8 / (3 * pi()), 7)};
}

Finding torque_orders() {
  const Trial inner = order([](const Real& u) { return Real(exact(uniform, u).eta - torque_inner(u)); }, 8);
  const Trial outer =
      order([](const Real& w) { return Real(exact(uniform, 1 / w).eta - torque_outer(w)); }, 7);
  return {worst({inner, outer}),
          {},
          order_bound,
          "Remainders fall with the powers " + text(inner.obtained) + " of u and " + text(outer.obtained) +
              " of 1/u. At u = 1: " + text(torque_inner(1), 7) + " and " + text(torque_outer(1), 7) +
              ", exact 8/(9π) = " + text(8 / (9 * pi()), 7)};
}

Finding disk() {
  const Contact c;
  const double g1 = 0.8;
  const double g2 = -1.7;
  double support = 0;
  const int directions = 3600;
  for (int i = 0; i < directions; ++i) {
    const double a = 2 * std::numbers::pi * i / directions;
    support = std::max(support, c.mu * c.lambda_n * (g1 * std::cos(a) + g2 * std::sin(a)));
  }
  const Trial t = relative(c.mu * c.lambda_n * std::hypot(g1, g2), support);
  // Nearest of 3600 directions: 1 − cos(π/3600).
  return {
      t,
      {},
      1e-6,
      "Support function of D_T by brute force over 3600 boundary points against Φ of pure sliding (2.10): " +
          text(t.error, 2)};
}

Finding disk_normal_cone() {
  const Contact c;
  const double g1 = 0.8;
  const double g2 = -1.7;
  const double g = std::hypot(g1, g2);
  const double top = c.mu * c.lambda_n;
  const double l1 = -top * g1 / g;
  const double l2 = -top * g2 / g;
  double largest = -1;
  for (int i = 0; i < 360; ++i) {
    for (int j = 0; j <= 10; ++j) {
      const double a = std::numbers::pi * i / 180;
      const double d1 = top * j / 10 * std::cos(a);
      const double d2 = top * j / 10 * std::sin(a);
      largest = std::max(largest, -g1 * (d1 - l1) - g2 * (d2 - l2));
    }
  }
  return {at_most_zero(largest),
          {},
          1e-14,
          "λ_T = −μλ_N γ_T/‖γ_T‖: the largest −γ_T·(d − λ_T) over 3960 points d of D_T is " +
              text(largest, 2) + " (must be <= 0)"};
}

Finding normalisation() {
  const Contact c;
  const double torque = resultant(uniform, c).torque;
  const Trial t = relative(torque * c.omega, torque / c.radius * (c.omega * c.radius));
  return {t, {}, 1e-15, "λ_τγ_τ = τ_Nω: the pair keeps its power, to " + text(t.error, 2)};
}

/// Orders of (2.18) along the exact border; the same numbers serve (2.19), where ξ is the length of λ_T.
Finding plate(bool ball) {
  const auto turned = [&](const Exact& e) {
    // A force of the ball in a generic direction, and ξ = ‖λ_T‖/(μλ_N) of it.
    return ball ? Real(sqrt(pow(e.xi * cos(Real(2)), 2) + pow(e.xi * sin(Real(2)), 2))) : e.xi;
  };
  const Trial inner = order(
      [&](const Real& u) {
        const Exact e = exact(uniform, u);
        return Real(plate_inner_printed(turned(e), e.eta) - 1);
      },
      8);
  const Trial outer = order(
      [&](const Real& w) {
        const Exact e = exact(uniform, 1 / w);
        return Real(plate_outer_printed(turned(e), e.eta) - 1);
      },
      8);
  return {worst({inner, outer}),
          {},
          order_bound,
          "On the exact border the left sides differ from 1 with the powers " + text(inner.obtained) +
              " of ξ and " + text(outer.obtained) + " of η. Exact elimination, after 9/4 η² and ξ²: " +
              text(plate_inner(uniform_inner(6))) + "; " + text(plate_outer(uniform_outer(6)))};
}

Finding plate_seam() {
  const Real seam = ratio(55, 64);
  const Real below = sqrt((1 - plate_inner_printed(seam, 0)) * 4 / 9);
  Real low = 0;
  Real high = ratio(1, 2);
  for (int i = 0; i < 160; ++i) {
    const Real eta = (low + high) / 2;
    (plate_outer_printed(seam, eta) < 1 ? low : high) = eta;
  }
  // Exact: η is continuous through u = 1, |dη/du| < 1 there.
  const Real step = Real(1e-20);
  const Trial exact_jump = absolute(exact(uniform, 1 - step).eta, exact(uniform, 1 + step).eta);
  return {absolute(below, low), exact_jump, 1e-19,
          "At ξ* = 55/64 the border is η = " + text(below, 7) + " from the inner piece and " + text(low, 7) +
              " from the outer one: a step of " + text(low - below, 3) +
              " outwards. Exact jump across u = 1 ± 1e-20: " + text(exact_jump.error, 2)};
}

/// λ_F against a cloud of forces of the exact ball: the largest −γ_F·(b − λ_F).
Finding ball_normal_cone(Pressure pressure) {
  std::vector<Exact> border;
  for (int i = 0; i <= 40; ++i) border.push_back(exact(pressure, tan(pi() / 2 * (2 * i + 1) / 83)));
  Real largest = -1;
  for (const char* number : {"0.05", "0.6", "1", "1.7", "30"}) {
    const Real u(number);
    const Exact e = exact(pressure, u);
    for (const Exact& b : border) {
      for (int k = 0; k < 8; ++k) {
        for (const int side : {-1, 1}) {
          // γ_F = (u, 0, 1), λ_F = −(ξ, 0, η); b turned by kπ/4, above and below
          const Real b1 = b.xi * cos(pi() * k / 4);
          largest = std::max(largest, Real(-u * (b1 + e.xi) - (side * b.eta + e.eta)));
        }
      }
    }
  }
  return {at_most_zero(largest),
          {},
          digits50,
          "λ_F of the exact law at u = 0.05 to 30 against 656 points b of the exact ball: the largest "
          "−γ_F·(b − λ_F) is " +
              text(largest, 3) + " (must be <= 0)"};
}

Finding power() {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) {
    const auto [force, torque] = resultant(uniform, c);
    trials.push_back(relative(potential_by_definition(uniform, c),
                              force * c.v + torque / c.radius * (c.omega * c.radius)));
  }
  const Trial t = worst(trials);
  return {t, {}, nested, "−λ_F·γ_F = Φ for 10 contacts (Euler's theorem), to " + text(t.error, 2)};
}

}  // namespace

std::vector<Row> section2() {
  return {
      {"2.1", "(2.1)", "Φ = ∬_A μσ‖w‖ dA", Flaw::none, "", "", definition},
      {"2.2", "(2.2)", "Φ = μλ_N/(πR²) ∫∫ ρ √(v² + (ωρ)² − 2ωρv sin φ) dφ dρ", Flaw::none, "", "",
       polar_integral},
      {"2.3", "(2.3)", "α = v/(ωρ), β = 1/α, R* = |v/ω|", Flaw::none, "", "", auxiliary_variables},
      {"2.4", "(2.4)", "Φ as two integrals, R* < ρ < R in α and 0 < ρ < R* in β", Flaw::none, "", "", split},
      {"2.4.alpha", "(2.4), text below", "α < 1 in the first integral and α > 1, i.e. β < 1, in the second",
       Flaw::imprecise, "|α| < 1 and |α| > 1, i.e. |β| < 1",
       "v and ω may have opposite signs; the series are even, so nothing else changes.", alpha_sign},
      {"2.5", "(2.5)", "∫√(x² + 1 − 2x sin φ) dφ = π(2 + x²/2 + x⁴/32 + x⁶/128) + O(x⁸)", Flaw::none, "", "",
       ring_series},
      {"2.5.range", "(2.5), range", "x < 1", Flaw::imprecise, "|x| < 1 (and x = ±1)", "As for (2.4).",
       ring_range},
      {"2.6", "(2.6)", "Φ for R* < R by termwise integration, four lines", Flaw::none, "", "",
       truncated_potential},
      {"2.6.line1", "(2.6) line 1", "(2.4) with (2.5) for either root", Flaw::none, "", "",
       truncated_potential_first_line},
      {"2.6.line2", "(2.6) line 2", "the same with α, β written out", Flaw::none, "", "",
       [] { return truncated_potential_line(2); }},
      {"2.6.line3", "(2.6) line 3", "antiderivatives 2ρ³/3 + ..., ρ² + ... between 0, R* and R", Flaw::none,
       "", "", [] { return truncated_potential_line(3); }},
      {"2.6.line4", "(2.6) line 4", "μλ_N|ω|R (2/3 + u²/2 − u⁴/32 − u⁶/384) − μλ_N (5/3072) v³/(ωR)²",
       Flaw::none, "", "Read here for v > 0; see the next row.", [] { return truncated_potential_line(4); }},
      {"2.6.last_term", "(2.6), last term", "− μλ_N (5/3072) v³/(ωR)²", Flaw::imprecise,
       "− μλ_N (5/3072) |v|³/(ωR)²",
       "Coefficient, sign and power are right; for v < 0 the term would change the sign of an even function.",
       last_term},
      {"2.6.vanishes", "(2.6), text below",
       "This small term tends to zero if (2.5) is approximated with more terms", Flaw::none, "",
       "It falls like N⁻³, so slowly because the series of (2.5) is singular at x = 1.", last_term_vanishes},
      {"2.7", "(2.7)", "Φ for R* > R: μλ_N/(πR²) ∫∫ |v|ρ √(β² + 1 − 2β sin φ) dφ dρ", Flaw::none, "", "",
       slow_spin_integral},
      {"2.8", "(2.8)",
       "Φ = μλ_N|ω|R (2/3 + u²/2 − u⁴/32 − u⁶/384 + O(u⁸)); (u + 1/(8u) + 1/(192u³) + 1/(1024u⁵) + O(u⁻⁷))",
       Flaw::none, "", "The library offers these truncated forms beside the exact law.", potential_orders},
      {"2.9", "(2.9)",
       "Φ = μλ_N|v| (2/(3u) + u/2 − u³/32 − u⁵/384 + O(u⁷)); (1 + 1/(8u²) + 1/(192u⁴) + 1/(1024u⁶) + O(u⁻⁸))",
       Flaw::none, "", "", potential_orders_over_v},
      {"2.10", "(2.10)", "Φ_{ω=0} = μλ_N|v| = μλ_N‖γ_T‖, Φ_{v=0} = (2/3)μλ_N|ω|R", Flaw::none, "",
       "The machine-read text has y_T for γ_T.", pure_motions},
      {"2.11", "(2.11)", "−λ_T ∈ ∂_{γ_T}Φ, −τ_N ∈ ∂_ωΦ", Flaw::wrong, "−(λ_T, τ_N) ∈ ∂_{(γ_T, ω)}Φ, jointly",
       "Equivalent where γ_F ≠ 0. At rest the two separate inclusions admit the whole disk × interval and "
       "contradict (2.18) to (2.20); "
       "the joint one is the friction ball, which this library implements.",
       subdifferential_at_rest},
      {"2.12", "(2.12)", "−λ_T ∈ ∂‖γ_T‖ ∇_{|v|}Φ, −τ_N ∈ ∂|ω| ∇_{|ω|}Φ", Flaw::imprecise,
       "the same for γ_F ≠ 0 only",
       "On the axes the rule is right (∇_{|v|}Φ = 0 at v = 0, ω ≠ 0, so λ_T = 0); at the origin Φ has no "
       "gradient in (|v|, |ω|).",
       chain_rule},
      {"2.13", "(2.13)", "λ_T: u − u³/8 − u⁵/64 + O(u⁷); 1 − 1/(8u²) − 1/(64u⁴) − 5/(1024u⁶) + O(u⁻⁸)",
       Flaw::none, "",
       "Truncated, the force falls by 5/1024 μλ_N as u passes 1 upwards: the printed law is not monotone "
       "there.",
       force_orders},
      {"2.14", "(2.14)", "τ_N: 2/3 − u²/2 + 3u⁴/32 + 5u⁶/384 + O(u⁸); 1/(4u) + 1/(48u³) + 3/(512u⁵) + O(u⁻⁷)",
       Flaw::none, "", "Truncated, the torque rises by 5/1536 μλ_N R as u passes 1 upwards.", torque_orders},
      {"2.15", "(2.15)", "D_T = {λ_T | ‖λ_T‖ <= μλ_N}", Flaw::none, "", "", disk},
      {"2.16", "(2.16)", "−γ_T ∈ N_{D_T}(λ_T)", Flaw::none, "", "", disk_normal_cone},
      {"2.17", "(2.17)", "λ_τ = τ_N/R, γ_τ = ωR", Flaw::none, "",
       "Needs R > 0; at R = 0 use the pair (τ_N, ω).", normalisation},
      {"2.18", "(2.18)",
       "(9/4)η² + (3/2)ξ² − (15/32)ξ⁴ − (5/128)ξ⁶ + O(ξ⁸) <= 1; ξ² + 4η² − (20/3)η⁴ + (40/9)η⁶ + O(η⁸) <= 1",
       Flaw::none, "", "As series they are right; cut after three terms see the next row and plates.tsv.",
       [] { return plate(false); }},
      {"2.18.seam", "(2.18), the border at ξ*", "one set, with ξ <= ξ* and ξ > ξ*, ξ* = 1 − 1/8 − 1/64",
       Flaw::imprecise, "continuous only with all terms and ξ* = 8/(3π)",
       "Taken to the letter, with three terms, P_F and B_F are neither convex nor closed at the seam: "
       "projection and normal cone, (2.20), "
       "are not defined there. This library uses the exact border.",
       plate_seam},
      {"2.19", "(2.19)", "B_F: (2.18) with ξ = ‖λ_T‖/(μλ_N) of the two-vector λ_T", Flaw::none, "", "",
       [] { return plate(true); }},
      {"2.20", "(2.20)", "−γ_F ∈ N_{B_F}(λ_F)", Flaw::none, "", "",
       [] { return ball_normal_cone(Pressure::uniform); }},
      {"2.21", "(2.21)", "γ_F = (γ_T1, γ_T2, γ_τ), λ_F = (λ_T1, λ_T2, λ_τ)", Flaw::none, "", "", power},
  };
}

}  // namespace verify::ledger
