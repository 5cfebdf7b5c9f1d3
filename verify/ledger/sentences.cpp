// The quantitative sentences of LG03 Sections 2 and 3 (and two of Section 1 that the theory rests on).

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle.hpp"

namespace verify::ledger {
namespace {

constexpr Pressure uniform = Pressure::uniform;
constexpr Pressure hertz = Pressure::hertz;

Real uniform_xi(const Real& u) { return exact(uniform, u).xi; }
Real uniform_eta(const Real& u) { return exact(uniform, u).eta; }

/// Directions u = tan ψ spread over (0, ∞).
std::vector<Real> directions(int count) {
  std::vector<Real> u;
  for (int i = 0; i < count; ++i) u.push_back(tan(pi() / 2 * (2 * i + 1) / (2 * count)));
  return u;
}

Finding vanishing_force() {
  const Real u = Real("1e-8");
  const Trial t = worst({absolute(0, exact(uniform, u).xi), absolute(0, exact(hertz, u).xi)});
  return {t,
          {},
          2e-8,
          "v/(ωR) = 1e-8: ‖λ_T‖/(μλ_N) = " + text(exact(uniform, u).xi) + " (uniform), " +
              text(exact(hertz, u).xi) + " (Hertz)"};
}

Finding torque_proportional() {
  // τ_N ω = Φ at v = 0.
  const auto torque = [](Pressure pressure, Contact c) {
    c.v = 0;
    return potential_by_definition(pressure, c) / c.omega;
  };
  std::vector<Trial> trials;
  for (const Pressure pressure : {uniform, hertz}) {
    Contact c;
    const double once = torque(pressure, c);
    c.mu *= 2;
    c.lambda_n *= 3;
    c.radius *= 5;
    trials.push_back(relative(30 * once, torque(pressure, c)));
  }
  const Trial t = worst(trials);
  return {
      t, {}, nested, "Doubling μ, tripling λ_N, R times five: τ_N becomes 30 times, to " + text(t.error, 2)};
}

/// Surface displacement under (1 − ρ²)ⁿ as a sum over chords of
/// half length h: n = 1: ∫(h² − t²) dt = 4h³/3; n = ½: πh²/2.
Real sag(const Real& u, bool paraboloid) {
  const auto displacement = [&](const Real& at) {
    return integrate(
        [&](const Real& theta) -> Real {
          const Real h2 = 1 - pow(at * sin(theta), 2);
          return paraboloid ? Real(4 * h2 * sqrt(h2) / 3) : Real(pi() * h2 / 2);
        },
        0, pi());
  };
  return displacement(0) - displacement(u);
}

Finding spherical_contact() {
  const Real u = ratio(9, 10);
  const Real parabola = sag(u, true) / sag(u / 2, true);
  const Real root = sag(u, false) / sag(u / 2, false);
  return {relative(4, parabola), relative(4, root), 1e-14,
          "Under σ ∝ 1 − ρ²/R² the elastic surface sinks between 0 and 0.9 R by " + text(parabola, 7) +
              " times what it sinks to 0.45 R; a sphere needs 4, and σ ∝ √(1 − ρ²/R²) gives " +
              text(root, 16)};
}

Finding edge_pressure() {
  const Real rho2 = pow(1 - Real("1e-12"), 2);
  const Real punch = 1 / (2 * sqrt(1 - rho2));  // over the mean
  const Real sphere = ratio(3, 2) * sqrt(1 - rho2);
  // The chord integral of (h² − t²)^{−1/2}, t = h sin a, is that
  // of 1: the surface under the punch stays flat, as it must.
  const auto chord = [](const Real& h) {
    return integrate([&](const Real& a) -> Real { return h * cos(a) / sqrt(h * h * cos(a) * cos(a)); },
                     -pi() / 2, pi() / 2);
  };
  return {absolute(0, punch), absolute(0, sphere), 1e-5,
          "Flat rigid punch, σ/mean = ½(1 − ρ²/R²)^{−1/2}: " + text(punch, 3) +
              " at ρ = (1 − 1e-12)R, and its surface is flat (chord integrals π to " +
              text(relative(chord(ratio(1, 5)), chord(ratio(9, 10))).error, 2) +
              "); Hertz: " + text(sphere, 2)};
}

Finding normal_force() {
  std::vector<Trial> trials;
  for (const Pressure pressure : {uniform, hertz}) {
    for (const Contact& c : positive_contacts()) {
      trials.push_back(relative(
          c.lambda_n, over_disc(c, [&](double rho, double) { return pressure_at(pressure, c, rho); })));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, nested, "σ = λ_N/(πR²) and σ of (3.4), to " + text(t.error, 2)};
}

Finding element_velocity() {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) {
    for (const double phi : {0.3, 2.2, 4.0}) {
      const double rho = 0.4;
      // The point x(t) of a body that turns by ωt about e_3
      // and moves with v along e_1, differentiated at t = 0.
      const double h = 1e-5;
      const auto x = [&](double t) { return c.v * t + rho * std::cos(phi + c.omega * t); };
      const auto y = [&](double t) { return rho * std::sin(phi + c.omega * t); };
      trials.push_back(absolute(c.v - c.omega * rho * std::sin(phi), (x(h) - x(-h)) / (2 * h)));
      trials.push_back(absolute(c.omega * rho * std::cos(phi), (y(h) - y(-h)) / (2 * h)));
    }
  }
  const Trial t = worst(trials);
  // Central difference: h²ω³ρ/6 = 2e-10, rounding 1e-16/h = 1e-11.
  return {
      t,
      {},
      1e-9,
      "Differentiated motion of 3 points for 10 contacts: largest difference " + text(t.error, 2) + " m/s"};
}

Finding element_force() {
  // Twice the speed must leave a Coulomb force as it is.
  const double mu = 0.3;
  const double sigma = 1.7;
  const auto printed = [&](double w) { return mu * sigma * w; };
  const auto corrected = [&](double) { return mu * sigma; };
  const Contact c;
  // and the force it adds up to, at ω = 0, must be μλ_N: ∬ μσ‖w‖ dA is μλ_N v
  return {
      relative(printed(0.8), printed(1.6)), relative(corrected(0.8), corrected(1.6)), 1e-15,
      "Doubling ‖w‖ doubles it (a viscous law, N·m/s in dimension); at ω = 0, v = 1.3 it would add up to " +
          text(c.mu * c.lambda_n * c.v) + " instead of μλ_N = " + text(c.mu * c.lambda_n)};
}

Finding dissipation_sign() {
  // One element at ω = 0: −dλ_T ∈ ∂(μσ‖w‖) gives dλ_T = −μσ w/‖w‖.
  const double mu_sigma = 0.3 * 1.7;
  const double w1 = 0.8;
  const double w2 = -1.1;
  const double w = std::hypot(w1, w2);
  const double product = -mu_sigma * (w1 * w1 + w2 * w2) / w;
  return {relative(mu_sigma * w, product), relative(mu_sigma * w, -product), 1e-15,
          "With dλ_T = −μσ dA w/‖w‖, which (2.11) asks for, wᵀdλ_T = " + text(product) +
              " dA and μσ‖w‖ = " + text(mu_sigma * w) + " dA"};
}

Finding slip_ratio() {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) trials.push_back(relative(c.u(), std::abs(c.v / c.omega) / c.radius));
  const Trial t = worst(trials);
  return {t, {}, 1e-15, "10 contacts, to " + text(t.error, 2)};
}

Finding pure_potentials() {
  // Convex: the midpoint of any two arguments; non-smooth: slopes ±1 (±2/3) at either side of zero.
  Real violation = -1;
  for (const char* a : {"-1.3", "0.2", "2"}) {
    for (const char* b : {"-0.7", "0.5", "1.9"}) {
      violation = std::max(violation, Real(abs((Real(a) + Real(b)) / 2) - (abs(Real(a)) + abs(Real(b))) / 2));
    }
  }
  const Real h = Real("1e-20");
  const Real kink =
      (exact(uniform, 1 / h).f * h - (-exact(uniform, 1 / h).f * h));  // Φ(h, 0)/h on either side, ω → 0
  const Trial t = worst({at_most_zero(violation), relative(2, kink)});
  return {t,
          {},
          1e-15,
          "The slope of Φ_{ω=0}/(μλ_N) jumps by " + text(kink, 10) +
              " at v = 0; no midpoint lies above its chord"};
}

Finding cone() {
  std::vector<Trial> trials;
  for (const Pressure pressure : {uniform, hertz}) {
    for (Contact c : contacts()) {
      const double once = potential_by_definition(pressure, c);
      c.v *= 3;
      c.omega *= 3;
      trials.push_back(relative(3 * once, potential_by_definition(pressure, c)));
    }
  }
  const Trial t = worst(trials);
  return {t, {}, nested, "Φ(3v, 3ω) = 3Φ(v, ω), 10 contacts and both pressures, to " + text(t.error, 2)};
}

Finding contour_lines() {
  // On Φ/(μλ_N) = 1: ωR = 1/f, v = u/f. The ellipse through the same vertices: v² + (2/3 ωR)² = 1. The
  // rectangle: |v| <= 1, |ωR| <= 3/2.
  std::vector<Trial> trials;
  Real farthest = 0;
  for (const Real& u : directions(60)) {
    const Real f = exact(uniform, u).f;
    const Real v = u / f;
    const Real s = 1 / f;
    const Real ellipse = sqrt(v * v + 4 * s * s / 9);
    trials.push_back(at_most_zero(1 - ellipse));
    trials.push_back(at_most_zero(v - 1));
    trials.push_back(at_most_zero(s - ratio(3, 2)));
    farthest = std::max(farthest, ellipse);
  }
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "In 60 directions the contour lies outside the ellipse and inside the rectangle through its "
          "vertices; at most " +
              text(100 * (farthest - 1), 3) + " % outside the ellipse"};
}

Finding smoothness() {
  // f''' by second differences of ξ at 1 ± ε, with a step of ε/1000; f'' by first differences.
  const auto third = [](const Real& u, const Real& h) -> Real {
    return (uniform_xi(u + h) - 2 * uniform_xi(u) + uniform_xi(u - h)) / (h * h);
  };
  const auto second = [](const Real& u, const Real& h) -> Real {
    return (uniform_xi(u + h) - uniform_xi(u - h)) / (2 * h);
  };
  const Real e2 = Real("1e-2");
  const Real e4 = Real("1e-4");
  const Real f2 = third(1 - e2, e2 / 1000);
  const Real f4 = third(1 - e4, e4 / 1000);
  const Real per_decade = (f4 - f2) / 2;
  const Trial jump = absolute(second(1 - e4, e4 / 1000), second(1 + e4, e4 / 1000));
  return {absolute(0, per_decade), jump, 0.01,
          "Third derivative of Φ at u = 1 − 1e-2, 1 − 1e-4: " + text(f2, 5) + ", " + text(f4, 5) + ", " +
              text(per_decade, 4) + " more each decade (in units of μλ_N/(ωR)²); the second differs by " +
              text(jump.error, 2) + " across 1 ± 1e-4. At the origin: see (2.12)"};
}

Finding where_set_valued() {
  // Φ(v, s): jump of the slope across the axes, away from
  // the origin, and at the origin, all in units of μλ_N.
  const Real h = Real("1e-10");
  const Real across_spin = 2 * (exact(uniform, h).f - exact(uniform, Real("1e-30")).f) / h;  // Φ(±h, 1)
  const Real across_slide = 2 * (exact(uniform, 1 / h).f * h - 1) / h;                       // Φ(1, ±h)
  const Trial t = worst({absolute(0, across_spin), absolute(0, across_slide)});
  // f = 2/3 + u²/2: the slope jump over h is h.
  return {t,
          {},
          1e-9,
          "Jump of ∂Φ/∂v across v = 0 at ωR = 1, and of ∂Φ/∂(ωR) across ω = 0 at v = 1, over 1e-10: " +
              text(across_spin, 2) + ", " + text(across_slide, 2) + "; at the origin 2 and 4/3"};
}

/// Sums of the torque and force series at u = 1 to `count` terms; a_k = 2 C(1/2, k)² of (2.5).
struct SeamSums {
  Real eta_inner = 0;
  Real eta_outer = 0;
  Real xi_inner = 0;
};
SeamSums seam_sums(int count) {
  SeamSums s;
  Real c = 1;
  for (int k = 0; k < count; ++k) {
    const Real a = 2 * c * c;
    const Real inner = -a / (2 * k - 3);
    const Real outer = a / (2 * k + 2);
    s.eta_inner += inner * (1 - 2 * k);
    s.eta_outer += outer * 2 * k;
    s.xi_inner += inner * 2 * k;
    c *= (ratio(1, 2) - k) / (k + 1);
  }
  return s;
}

Finding series_meet() {
  const Real left = ratio(2, 3) - ratio(1, 2) + ratio(3, 32) + ratio(5, 384);
  const Real right = ratio(1, 4) + ratio(1, 48) + ratio(3, 512);
  const int count = 4000;
  const SeamSums s = seam_sums(count);
  const Real limit = 8 / (9 * pi());
  const Trial corrected = worst({relative(limit, s.eta_inner), relative(limit, s.eta_outer)});
  // Terms fall like k⁻³/π: the tail after N is below 1/N² = 6e-8.
  return {relative(left, right), corrected, 1e-7,
          "The two numbers are 105/384 = " + text(left, 7) + " and 425/1536 = " + text(right, 7) +
              ", 1.2 % apart, and " + text(100 * (1 - left / limit), 2) + " % and " +
              text(100 * (1 - right / limit), 2) + " % below the value both series tend to, 8/(9π) = " +
              text(limit, 7) + "; 4000 terms: " + text(s.eta_inner, 9) + ", " + text(s.eta_outer, 9)};
}

Finding seam_series() {
  const Real limit = 8 / (3 * pi());
  const Trial t = worst({relative(limit, seam_sums(4000).xi_inner), relative(limit, uniform_xi(1))});
  return {t,
          {},
          1e-7,
          "The series at u = 1 tends to 8/(3π) = " + text(limit, 8) +
              "; the three terms written are 55/64 = " + text(ratio(55, 64), 8) +
              ", 1.2 % more. All later terms are negative (the next is −5/1024)"};
}

Finding axisymmetric() {
  std::vector<Trial> trials;
  const Contact c;
  for (const Pressure pressure : {uniform, hertz}) {
    for (const double turn : {0.7, 2.9}) {
      // γ_T = v (cos, sin)(turn); φ counted from γ_T, so that the kink lies where over_disc splits
      const double turned = over_disc(c, [&](double rho, double from) {
        const double phi = from + turn;
        const double w1 = c.v * std::cos(turn) - c.omega * rho * std::sin(phi);
        const double w2 = c.v * std::sin(turn) + c.omega * rho * std::cos(phi);
        return c.mu * pressure_at(pressure, c, rho) * std::hypot(w1, w2);
      });
      trials.push_back(relative(potential_by_definition(pressure, c), turned));
    }
  }
  const Trial t = worst(trials);
  return {
      t,
      {},
      nested,
      "The support function of B_F, Φ, does not change as γ_T turns by 0.7 and 2.9, to " + text(t.error, 2)};
}

Finding disk_section() {
  // B_F is convex and symmetric in λ_τ, so its section λ_τ = 0 is its shadow: a disk of radius sup ξ.
  const Real far = Real("1e15");
  const Trial t = relative(1, uniform_xi(far));
  return {t, {}, 1e-20, "sup ξ/(μλ_N) = ξ(1e15) = 1 − " + text(1 - uniform_xi(far), 2)};
}

Finding plate_section() {
  // Half width, along λ_T2, of the section at λ_T1 = d: the
  // ball is the border curve turned about the λ_τ axis.
  const auto half_width = [](const Real& d) -> Real { return sqrt(1 - d * d); };
  return {relative(1, half_width(ratio(1, 2))), relative(1, half_width(0)), 1e-15,
          "The plane λ_T1 = μλ_N/2 is orthogonal to D_T and cuts B_F to ‖λ_T2‖ <= " +
              text(half_width(ratio(1, 2)), 4) + " μλ_N; through the axis it is 1"};
}

Finding origin() {
  const Real small = Real("1e-12");
  const Trial t = worst({absolute(0, uniform_xi(small)), absolute(0, uniform_eta(1 / small))});
  return {t,
          {},
          2e-12,
          "ξ at u = 1e-12: " + text(uniform_xi(small), 3) +
              "; η at 1/u = 1e-12: " + text(uniform_eta(1 / small), 3)};
}

Finding figure5_caption() {
  const Real small = Real("1e-12");
  return {absolute(0, uniform_eta(small)), absolute(0, uniform_eta(1 / small)), 1e-11,
          "η at u = 1e-12 is " + text(uniform_eta(small)) + ", at 1/u = 1e-12 " +
              text(uniform_eta(1 / small), 2) +
              "; the drawn curve starts at the origin, as the text says of 1/u"};
}

Finding asymptotes() {
  const Real far = Real("1e12");
  const Trial t = worst({relative(1, uniform_xi(far)), relative(ratio(2, 3), uniform_eta(1 / far))});
  return {t, {}, 1e-20, "At u = 1e12 and 1/u = 1e12: ξ = 1, η = 2/3 to " + text(t.error, 2)};
}

Finding single_valued() {
  const Real v = Real("1e-30");
  const Trial t = absolute(0, 2 * uniform_xi(v));
  return {t, {}, 1e-29, "λ_T/(μλ_N) jumps by " + text(2 * uniform_xi(v), 2) + " between v = ∓1e-30 γ_τ"};
}

Finding smoothing() {
  const Real v = Real("1e-12");
  const Trial t = worst({relative(1, uniform_xi(v) / v), relative(ratio(1, 4), uniform_eta(1 / v) / v)});
  return {
      t,
      {},
      1e-20,
      "Slopes at the origin: ∂‖λ_T‖/∂v = μλ_N/γ_τ and ∂λ_τ/∂γ_τ = μλ_N/(4v), finite, to " + text(t.error, 2)};
}

Finding classical_limits() {
  Contact sliding;
  sliding.omega = 0;
  Contact spinning;
  spinning.v = 0;
  const Trial t =
      worst({relative(sliding.mu * sliding.lambda_n, potential_by_definition(uniform, sliding) / sliding.v),
             relative(2 * spinning.mu * spinning.lambda_n * spinning.radius / 3,
                      potential_by_definition(uniform, spinning) / spinning.omega)});
  return {t,
          {},
          nested,
          "‖λ_T‖ = μλ_N at ω = 0 and τ_N = (2/3)μλ_N R at v = 0 whatever the speed, to " + text(t.error, 2)};
}

Finding extremes() {
  Real xi = 0;
  Real eta = 0;
  for (const Real& u : directions(40)) {
    const Exact e = exact(uniform, u);
    xi = std::max(xi, e.xi);
    eta = std::max(eta, e.eta);
  }
  const Trial t = worst({at_most_zero(xi - 1), at_most_zero(eta - ratio(2, 3))});
  return {t,
          {},
          digits50,
          "Over 40 points of the border max ξ = " + text(xi, 7) + " (< 1), max η = " + text(eta, 7) +
              " (< 2/3); 1 and 2/3 are reached on the axes"};
}

Finding early_slip() {
  std::vector<Trial> trials;
  std::string pairs;
  for (const char* number : {"30", "3", "1", "0.3"}) {
    const Exact e = exact(uniform, Real(number));
    trials.push_back(at_most_zero(e.xi - 1 + Real("1e-6")));
    pairs += (pairs.empty() ? "" : "; ") + text(e.eta, 4) + " → " + text(e.xi, 6);
  }
  const Trial t = worst(trials);
  return {t, {}, 0, "Largest ‖λ_T‖/(μλ_N) beside a given λ_τ/(μλ_N): " + pairs};
}

/// max over directions of λ·γ − Φ(γ) for the force t times the border point at u = 1.
Real slack(const Real& t) {
  const Exact e = exact(uniform, 1);
  Real largest = -1;
  std::vector<Real> all = directions(60);
  all.push_back(1);
  for (const Real& u : all)
    largest = std::max(largest, Real((t * (e.xi * u + e.eta) - exact(uniform, u).f) / sqrt(1 + u * u)));
  return largest;
}

Finding slip_criterion() {
  const Real inside = slack(ratio(99, 100));
  const Real border = slack(1);
  const Trial t = worst({at_most_zero(inside + ratio(1, 1000)), absolute(0, border)});
  return {t,
          {},
          digits50,
          "λ·γ − Φ(γ), largest over directions: " + text(inside, 3) +
              " at 0.99 of a border point (no slip fits), " + text(border, 2) +
              " on the border (one direction fits). Necessary for slip; on the border a contact may also "
              "still stick"};
}

Finding vanishing_radius() {
  Contact c;
  c.radius = 1e-6;
  const Trial t = relative(c.mu * c.lambda_n * c.v, potential_by_definition(uniform, c));
  return {
      t,
      {},
      nested,
      "R = 1 µm, v = 1.3 m/s, ω = 2.9 rad/s: Φ = μλ_N‖γ_T‖ to " + text(t.error, 2) + " ((ωR/v)²/8 = 6e-13)"};
}

Finding parabolic_function() {
  // A parabola in ρ falls four times as far to 0.8 R as to 0.4 R.
  const auto sigma = [](const Real& rho) -> Real { return sqrt(1 - rho * rho); };
  const Real printed = (1 - sigma(ratio(4, 5))) / (1 - sigma(ratio(2, 5)));
  const Real corrected = (1 - pow(sigma(ratio(4, 5)), 2)) / (1 - pow(sigma(ratio(2, 5)), 2));
  return {relative(4, printed), relative(4, corrected), digits50,
          "σ(0) − σ(0.8R) is " + text(printed, 5) + " times σ(0) − σ(0.4R), a parabola has 4; σ² has " +
              text(corrected, 5)};
}

/// Largest differences between the laws of the two pressures.
struct Difference {
  Real xi_relative = 0;  // to uniform
  Real eta_relative = 0;
  Real eta_to_hertz = 0;
  Real xi_absolute = 0;
  Real xi_absolute_at = 0;
  Real eta_absolute = 0;
  Real eta_absolute_at = 0;
  Real eta_relative_at = 0;
  Real hausdorff = 0;
};
const Difference& difference() {
  static const Difference result = [] {
    Difference d;
    std::vector<Real> arguments = directions(60);
    for (const char* u : {"1e-6", "1e-3", "1e3", "1e6"}) arguments.emplace_back(u);
    for (const Real& u : arguments) {
      const Exact a = exact(uniform, u);
      const Exact b = exact(hertz, u);
      d.xi_relative = std::max(d.xi_relative, Real(abs(b.xi / a.xi - 1)));
      if (abs(b.eta / a.eta - 1) > d.eta_relative) {
        d.eta_relative = abs(b.eta / a.eta - 1);
        d.eta_relative_at = u;
      }
      d.eta_to_hertz = std::max(d.eta_to_hertz, Real(abs(a.eta / b.eta - 1)));
      if (abs(b.xi - a.xi) > d.xi_absolute) {
        d.xi_absolute = abs(b.xi - a.xi);
        d.xi_absolute_at = u;
      }
      if (abs(b.eta - a.eta) > d.eta_absolute) {
        d.eta_absolute = abs(b.eta - a.eta);
        d.eta_absolute_at = u;
      }
      d.hausdorff = std::max(d.hausdorff, Real(abs(b.f - a.f) / sqrt(1 + u * u)));
    }
    return d;
  }();
  return result;
}

Finding twenty_percent() {
  const Difference& d = difference();
  const Real largest = std::max(d.xi_relative, d.eta_relative);
  // "About 20 percent", and the 23 percent it is, each to half a unit of its last digit as a percentage.
  return {absolute(ratio(20, 100), largest), absolute(ratio(23, 100), largest), 0.005,
          "Relative to uniform: λ_τ differs by up to " + text(100 * d.eta_relative, 3) +
              " % (at u = " + text(d.eta_relative_at, 2) +
              "; 20 % for u → ∞, 1/5 against 1/4), λ_T by up to " + text(100 * d.xi_relative, 3) +
              " % (u → 0, 3π/8 against 1). Relative to Hertz λ_τ differs by up to " +
              text(100 * d.eta_to_hertz, 3) + " %. In units of μλ_N: ‖λ_T‖ by " + text(d.xi_absolute, 3) +
              " (at u = " + text(d.xi_absolute_at, 2) + "), λ_τ by " + text(d.eta_absolute, 3) +
              " (at u = " + text(d.eta_absolute_at, 2) + ")"};
}

Finding similar_shape() {
  const Difference& d = difference();
  const Trial t = at_most_zero(d.hausdorff - ratio(1, 5));
  return {t,
          {},
          0,  // no farther than the 20 percent it is said to follow from
          "Hausdorff distance of the two balls (largest difference of Φ over unit γ_F): " +
              text(d.hausdorff, 4) + " μλ_N, at the poles (2/3 against 3π/16)"};
}

}  // namespace

std::vector<Row> sentences() {
  return {
      {"s1.vanishes", "Section 1", "the sliding friction force vanishes when the ratio v/(ωR) tends to zero",
       Flaw::none, "", "", vanishing_force},
      {"s1.torque", "Section 1, τ_N",
       "the friction torque is, without sliding, more or less proportional to normal force, friction "
       "coefficient and effective radius",
       Flaw::none, "", "Exactly so for a given shape of the pressure.", torque_proportional},
      {"s1.elementary",
       "Section 1, elliptic integrals",
       "The elliptic integrals cannot be simplified to elementary functions for a uniform pressure",
       Flaw::not_checkable,
       "",
       "",
       {},
       "A theorem of Liouville's theory; no number decides it."},
      {"s2.spherical", "Section 2, spherical bodies",
       "Contact between locally spherical bodies produces a parabolic pressure distribution according to "
       "Hertz",
       Flaw::imprecise, "a semi-ellipsoidal one, σ ∝ √(1 − ρ²/R²)",
       "The true paraboloid is n = 1 of this library's family; Hertz is n = 1/2.", spherical_contact},
      {"s2.flat",
       "Section 2, flat bodies",
       "Contact between locally flat bodies produces a more or less uniform pressure in the interior",
       Flaw::not_checkable,
       "",
       "For the flat rigid punch see the next row: half the mean pressure in the middle.",
       {},
       "\"More or less\" names no bound."},
      {"s2.edge", "Section 2, uniform pressure",
       "A purely uniform pressure distribution cannot exist because the pressure falls to zero at the "
       "boundary",
       Flaw::imprecise,
       "so for bodies that are smooth where contact ends; under a sharp edge it rises without bound",
       "This library's family covers it: n > −1, the punch is n = −1/2.", edge_pressure},
      {"s2.model",
       "Section 2, practice",
       "the pressure distribution can often well be modelled by a parabolic or a uniform distribution",
       Flaw::not_checkable,
       "",
       "",
       {},
       "A statement about practice without a bound."},
      {"s2.1.load", "Section 2.1, λ_N", "λ_N = ∬σ dA", Flaw::none, "", "", normal_force},
      {"s2.1.velocity", "Section 2.1, w", "w = (v − ωρ sin φ) e_1 + (ωρ cos φ) e_2", Flaw::none, "", "",
       element_velocity},
      {"s2.2.element", "Section 2.2, before (2.1)", "dλ_T = μσ dA‖w‖", Flaw::misprint, "‖dλ_T‖ = μσ dA",
       "The next sentence uses the right form.", element_force},
      {"s2.2.sign", "Section 2.2, dΦ", "dΦ = wᵀdλ_T = μσ‖w‖ dA", Flaw::imprecise, "dΦ = −wᵀdλ_T = μσ‖w‖ dA",
       "Friction opposes motion: with the sign convention of (2.11) to (2.20) the product is negative.",
       dissipation_sign},
      {"s2.2.u", "Section 2.2, u", "u = |v|/(|ω|R) = R*/R", Flaw::none, "", "", slip_ratio},
      {"s2.2.convex", "Section 2.2, below (2.10)", "both non-smooth convex potentials", Flaw::none, "", "",
       pure_potentials},
      {"s2.2.cone", "Section 2.2, cone", "The velocity potential Φ forms a cone as function of v and ωR",
       Flaw::none, "", "", cone},
      {"s2.2.contours", "Section 2.2, Fig. 2",
       "The contour lines of the cone are a form between an ellipse and a rectangle", Flaw::none, "", "",
       contour_lines},
      {"s2.3.smooth", "Section 2.3, below (2.12)",
       "the velocity potential is a smooth function of |v| and |ω|", Flaw::imprecise,
       "twice continuously differentiable except at the origin",
       "Newton methods see a continuous Hessian for γ_F ≠ 0; orders above two are lost across |v| = |ω|R.",
       smoothness},
      {"s2.3.set", "Section 2.3, set-valued", "The force laws are set-valued at (v, ωR) = 0", Flaw::none, "",
       "And only there.", where_set_valued},
      {"s2.3.meet", "Section 2.3, below (2.14)",
       "the series converge to the same value for u = 1 because 2/3 − 1/2 + 3/32 + 5/384 ≈ 1/4 + 1/48 + "
       "3/512",
       Flaw::imprecise, "the full series both converge to 8/(9π); the truncated ones differ by 5/1536",
       "A simulation that uses the printed forms sees a jump in the friction at |v| = |ω|R.", series_meet},
      {"s2.3.seam", "Section 2.3, ξ*", "ξ* = 1 − 1/8 − 1/64 + …", Flaw::none, "", "Write 8/(3π).",
       seam_series},
      {"s2.3.axis", "Section 2.3, B_F", "The squashed ball B_F is axisymmetric around the λ_τ axis",
       Flaw::none, "", "", axisymmetric},
      {"s2.3.disk", "Section 2.3, section λ_τ = 0",
       "The intersection of B_F with the (λ_T1, λ_T2) plane is formed by the friction disk D_T", Flaw::none,
       "", "", disk_section},
      {"s2.3.plate", "Section 2.3, P_F as a section",
       "Any intersection of B_F orthogonal to D_T will give the friction plate P_F", Flaw::imprecise,
       "any plane through the λ_τ axis; it gives P_F and its mirror image", "", plate_section},
      {"s2.3.origin", "Section 2.3, Fig. 5", "The functions both start at the origin", Flaw::none, "", "",
       origin},
      {"s2.3.asymptote", "Section 2.3, Fig. 5, asymptotes",
       "an asymptote at ‖λ_T‖ = μλ_N and |λ_τ| = (2/3)μλ_N respectively", Flaw::none, "", "", asymptotes},
      {"s2.3.single", "Section 2.3, Fig. 6(a)", "The curves for γ_τ > 0 are all single-valued functions of v",
       Flaw::none, "", "", single_valued},
      {"s2.3.smoothing", "Section 2.3, Fig. 6, smoothing",
       "a superimposed spin causes a smoothing effect of λ_T(v); the same occurs in λ_τ(γ_τ) for v > 0",
       Flaw::none, "", "", smoothing},
      {"s2.3.classical", "Section 2.3, Fig. 6, limits",
       "for γ_τ = 0 the classical set-valued characteristic of Coulomb, for v = 0 that of a purely "
       "rotational contact",
       Flaw::none, "", "", classical_limits},
      {"s2.3.extremes", "Section 2.3, extreme values",
       "μλ_N and (2/3)μλ_N are the extreme values of the friction ball along its principal axes", Flaw::none,
       "", "", extremes},
      {"s2.3.early", "Section 2.3, sticking",
       "A sticking contact will start slipping for ‖λ_T‖ < μλ_N if λ_τ ≠ 0", Flaw::none, "", "", early_slip},
      {"s2.3.slip", "Section 2.3, slip criterion", "The slip-criterion is given by (λ_T, λ_τ) ∈ ∂B_F(λ_N)",
       Flaw::none, "", "A necessary condition, as in Coulomb's law.", slip_criterion},
      {"s2.3.radius", "Section 2.3, R = 0",
       "reduces to the set-valued Coulomb's law when the contact radius vanishes (R = 0)", Flaw::none, "",
       "Of Φ and τ_N; the normalised λ_τ = τ_N/R of (2.17) has no meaning there.", vanishing_radius},
      {"s2.fig5", "Fig. 5, caption", "Friction force and torque as a function of u", Flaw::imprecise,
       "(a) over u, (b) over 1/u", "", figure5_caption},
      {"s3.small",
       "Section 3, contact radius",
       "the theoretical contact radius according to Hertz is for relatively hard bodies extremely small",
       Flaw::not_checkable,
       "",
       "",
       {},
       "\"Extremely\" names no bound; the row of (3.2) computes 70 µm for 3.5 N on a 15 mm sphere with E* = "
       "115 GPa."},
      {"s3.parabolic", "Section 3, before (3.4)",
       "The Hertz normal pressure distribution is given by the parabolic function", Flaw::imprecise,
       "semi-elliptic: σ² is parabolic", "As in Section 2.", parabolic_function},
      {"s3.similar",
       "Section 3.2, similar laws",
       "The force laws appear to be qualitatively similar",
       Flaw::not_checkable,
       "",
       "",
       {},
       "\"Qualitatively\" names no measure; the next row has one."},
      {"s3.twenty", "Section 3.2, 20 percent",
       "and differ maximally about 20 percent in magnitude (see Fig. 5)", Flaw::imprecise,
       "by up to 18 percent in λ_T and 23 percent in λ_τ",
       "To one digit the sentence holds; the largest difference is in the torque near |v| = 0.9 |ω|R, not in "
       "a limit.",
       twenty_percent},
      {"s3.shape", "Section 3.2, similar shape",
       "The friction plate and ball are therefore very similar in shape", Flaw::none, "", "", similar_shape},
  };
}

}  // namespace verify::ledger
