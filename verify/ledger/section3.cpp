// LG03 Section 3: the pressure of Hertz, (3.1) to (3.22).

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "elimination.hpp"
#include "oracle.hpp"

namespace verify::ledger {
namespace {

constexpr Pressure hertz = Pressure::hertz;

/// Arguments on both sides of u = 1.
const std::vector<Real>& inner_arguments() {
  static const std::vector<Real> u{ratio(1, 20), ratio(2, 5), ratio(9, 10), Real(1)};
  return u;
}
const std::vector<Real>& outer_arguments() {
  static const std::vector<Real> u{ratio(11, 10), ratio(17, 10), Real(10)};
  return u;
}

// The Hertz law as printed, in units of μλ_N (and μλ_N R|ω| for Φ).
Real potential_printed(const Real& u) {
  if (u <= 1) return 3 * pi() / 128 * (-pow(u, 4) + 8 * u * u + 8);
  return ratio(3, 64) * ((-pow(u, 4) + 8 * u * u + 8) * asin(1 / u) + (u * u + 14) * sqrt(u * u - 1));
}
Real force_printed(const Real& u) {
  if (u <= 1) return 3 * pi() / 32 * u * (-u * u + 4);
  return ratio(3, 16) / u * (u * u * (4 - u * u) * asin(1 / u) + (u * u + 2) * sqrt(u * u - 1));
}
Real torque_printed(const Real& u) {
  if (u <= 1) return 3 * pi() / 128 * (3 * pow(u, 4) - 8 * u * u + 8);
  return ratio(3, 64) * ((3 * pow(u, 4) - 8 * u * u + 8) * asin(1 / u) + (-3 * u * u + 6) * sqrt(u * u - 1));
}

Real seam_xi() { return 9 * pi() / 32; }
Real seam_eta() { return 9 * pi() / 128; }
Real plate_inner_side(const Real& xi, const Real& eta, const Real& sixth) {
  const Real x = xi / seam_xi();
  const Real y = eta / seam_eta();
  return ratio(9, 64) * y * y + ratio(9, 8) * x * x - ratio(243, 1024) * pow(x, 4) - sixth * pow(x, 6);
}
Real plate_outer_side(const Real& xi, const Real& eta) {
  return xi * xi + 5 * eta * eta - ratio(75, 7) * pow(eta, 4) + ratio(1250, 147) * pow(eta, 6);
}

/// Points (r, θ) of the plane, seen from the pole at distance
/// `pole` along e_2: ρ cos φ = r sin θ, ρ sin φ = pole − r cos θ.
struct Point {
  double x;
  double y;
};
Point from_pole(double r, double theta, double pole) {
  return {r * std::sin(theta), pole - r * std::cos(theta)};
}

/// (3.5) with the pole at `pole(contact)`: ‖w‖ against |ωr| over all signs of v and ω.
template <class Pole>
Trial speed_from_pole(Pole pole) {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) {
    for (const double r : {0.1, 0.5}) {
      for (const double theta : {0.3, 1.9, 2.8, 5.1}) {
        const auto [x, y] = from_pole(r, theta, pole(c));
        trials.push_back(relative(std::abs(c.omega * r), std::hypot(c.v - c.omega * y, c.omega * x)));
      }
    }
  }
  return worst(trials);
}

double unsigned_pole(const Contact& c) { return std::abs(c.v / c.omega); }
double signed_pole(const Contact& c) { return c.v / c.omega; }

Finding pole_coordinates() {
  // The pole of (3.1) is to be the point at rest, w = 0: r = 0 there.
  const auto speed_at_pole = [](auto pole) {
    std::vector<Trial> trials;
    for (const Contact& c : contacts()) trials.push_back(absolute(0, std::abs(c.v - c.omega * pole(c))));
    return worst(trials);
  };
  const Trial printed = speed_at_pole(unsigned_pole);
  return {printed, speed_at_pole(signed_pole), 1e-14,
          "Sliding velocity at the pole |v/ω| e_2: 0 for vω > 0, up to " + text(printed.obtained) +
              " m/s for vω < 0; at (v/ω) e_2 it is 0 for all signs"};
}

Finding speed() {
  const Trial printed = speed_from_pole(unsigned_pole);
  const Trial corrected = speed_from_pole(signed_pole);
  return {printed, corrected, 1e-13,
          "80 points, all signs of v and ω: with the pole at |v/ω| largest relative difference " +
              text(printed.error, 3) + " (from vω < 0), with the pole at v/ω " + text(corrected.error, 2)};
}

/// The surface displacement under σ is a sum over chords (Boussinesq): 1/(πE*) ∫_0^π dθ ∫ σ dr. A Hertz chord
/// of half length h (in units of R) holds ∫_{−h}^{h} √(h² − t²) dt = πh²/2.
Real displacement(const Real& u, const Real& mean_pressure, const Real& radius, const Real& modulus) {
  const Real chords =
      integrate([&](const Real& theta) -> Real { return pi() / 2 * (1 - pow(u * sin(theta), 2)); }, 0, pi());
  return ratio(3, 2) * mean_pressure * radius / (pi() * modulus) * chords;
}

Finding contact_radius() {
  // A sphere of radius ρ* on a plane: the displacement must be d − ρ²/(2ρ*) inside the contact.
  const Real load = ratio(7, 2);
  const Real rho = ratio(3, 200);
  const Real modulus = Real(115000000000LL);
  const Real radius = cbrt(3 * rho * load / (4 * modulus));
  const Real mean = load / (pi() * radius * radius);
  std::vector<Trial> trials;
  for (const char* number : {"0.25", "0.6", "1"}) {
    const Real u(number);
    const Real drop = displacement(0, mean, radius, modulus) - displacement(u, mean, radius, modulus);
    trials.push_back(relative(pow(u * radius, 2) / (2 * rho), drop));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "3.5 N on a 15 mm sphere, E* = 115 GPa: R = " + text(1e6 * radius, 5) +
              " µm; under this pressure the surface takes the sphere's parabola at 3 radii to " +
              text(t.error, 2) + ". 1/ρ* is the relative curvature, ρ* a length"};
}

/// Boussinesq's half-space under a unit normal load at the origin:
/// displacement (u_x, u_y, u_z) at (x, y, z), z > 0 inward.
std::array<Real, 3> boussinesq(const std::array<Real, 3>& p, const Real& shear, const Real& nu) {
  const auto& [x, y, z] = p;
  const Real r = sqrt(x * x + y * y + z * z);
  const Real front = 1 / (4 * pi() * shear);
  const Real radial = front * (z / (r * r * r) - (1 - 2 * nu) / (r * (r + z)));
  return {radial * x, radial * y, front * (2 * (1 - nu) / r + z * z / (r * r * r))};
}

Finding effective_modulus() {
  const Real young = Real(210);
  const Real nu = ratio(3, 10);
  const Real shear = young / (2 * (1 + nu));
  const Real lame = 2 * shear * nu / (1 - 2 * nu);
  // Second-order differences with step 1e-10: errors 1e-20 (truncation) and 1e-50/1e-20 = 1e-30 (rounding).
  const Real h = Real("1e-10");
  const std::array<Real, 3> p{ratio(3, 10), ratio(-2, 10), ratio(4, 10)};
  const auto at = [&](std::array<Real, 3> q, std::size_t i, int s, std::size_t j, int t) {
    q[i] += s * h;
    q[j] += t * h;
    return boussinesq(q, shear, nu);
  };
  const auto second = [&](std::size_t component, std::size_t i, std::size_t j) -> Real {
    if (i == j) {
      return (at(p, i, 1, i, 0)[component] - 2 * at(p, i, 0, i, 0)[component] +
              at(p, i, -1, i, 0)[component]) /
             (h * h);
    }
    return (at(p, i, 1, j, 1)[component] - at(p, i, 1, j, -1)[component] - at(p, i, -1, j, 1)[component] +
            at(p, i, -1, j, -1)[component]) /
           (4 * h * h);
  };
  std::vector<Trial> trials;
  for (std::size_t i = 0; i < 3; ++i) {
    Real laplace = 0;
    Real grad_div = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      laplace += second(i, j, j);
      grad_div += second(j, i, j);
    }
    trials.push_back(
        absolute(0, (shear * laplace + (lame + shear) * grad_div) / (shear * abs(second(i, i, i)))));
  }
  // It carries the load: −∫σ_zz over the plane z = 0.4 is
  // 1; σ_zz = λ div u + 2G ∂u_z/∂z by central differences.
  const auto sigma_zz = [&](const Real& r) -> Real {
    const std::array<Real, 3> q{r, Real(0), ratio(4, 10)};
    const auto difference = [&](std::size_t i) -> Real {
      return (at(q, i, 1, i, 0)[i] - at(q, i, -1, i, 0)[i]) / (2 * h);
    };
    return lame * (difference(0) + difference(1) + difference(2)) + 2 * shear * difference(2);
  };
  const Real carried = -integrate(
      [&](const Real& s) {
        // r = s/(1 − s)
        const Real r = s / (1 - s);
        return s < 1 ? Real(2 * pi() * r * sigma_zz(r) / ((1 - s) * (1 - s))) : Real(0);
      },
      0, ratio(999999, 1000000), Real(1e-20));
  const Trial load = relative(1, carried);
  // Its surface displacement is (1 − ν²)/(πE r): the compliances of two bodies add up to 1/(πE* r).
  const Trial surface = relative((1 - nu * nu) / (pi() * young * ratio(1, 2)),
                                 boussinesq({ratio(1, 2), Real(0), Real(0)}, shear, nu)[2]);
  trials.push_back(surface);
  const Trial t = worst(trials);
  // The load beyond r = 1e6 is of the order (z/r)³ = 1e-19.
  trials.push_back(load);
  return {worst(trials),
          {},
          1e-15,
          "Boussinesq's point load: equilibrium residual " + text(t.error, 2) + ", load carried " +
              text(carried, 16) + ", surface displacement (1 − ν²)/(πEr) to " + text(surface.error, 2) +
              ": the compliances of two bodies add"};
}

Finding pressure_members() {
  std::vector<Trial> trials;
  for (const char* number : {"0.3", "0.9", "1.6"}) {
    const Real u(number);
    for (const char* angle : {"0.2", "0.6", "2.4", "3.5"}) {
      const Real theta(angle);
      const Real q = ratio(1, 4) + u / 3;
      const Real x = q * sin(theta);
      const Real y = u - q * cos(theta);
      trials.push_back(absolute(1 - x * x - y * y, -q * q + 2 * q * u * cos(theta) + 1 - u * u));
    }
  }
  // λ_N = ∬σ dA, substitution ρ = sin a
  const Real total =
      integrate([](const Real& a) -> Real { return 3 * cos(a) * sin(a) * cos(a); }, 0, pi() / 2);
  trials.push_back(relative(1, total));
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "1 − ρ²/R² = −q² + 2qu cos θ + 1 − u² at 12 points (sign of cos θ as in (3.1)), ∬σ dA = λ_N: "
          "largest difference " +
              text(t.error, 2)};
}

/// ∬μσ‖w‖ over (r, θ) in double, radial factor as given; R* cos θ ± √(R² − R*² sin²θ) for the limits.
double pole_integral(const Contact& c, const std::function<double(double r, double sigma)>& integrand) {
  const double critical = unsigned_pole(c);
  const double mean = c.lambda_n / (std::numbers::pi * c.radius * c.radius);
  const auto chord = [&](double theta) {
    const double m = critical * std::cos(theta);
    const double s = critical * std::sin(theta);
    const double h = std::sqrt(std::max(0.0, (c.radius - s) * (c.radius + s)));
    const auto along = [&](double t) {
      return integrand(m + t, 1.5 * mean * std::sqrt(std::max(0.0, (h - t) * (h + t))) / c.radius);
    };
    // split at the pole, where |r| has its corner
    if (-m > -h && -m < h) return integrate_double(along, -h, -m) + integrate_double(along, -m, h);
    return h > 0 ? integrate_double(along, -h, h) : 0.0;
  };
  if (c.u() <= 1) {
    return integrate_double(chord, 0, std::numbers::pi / 2) +
           integrate_double(chord, std::numbers::pi / 2, std::numbers::pi);
  }
  return 2 * integrate_double(chord, 0, std::asin(1 / c.u()));
}

Finding pole_potential() {
  std::vector<Trial> printed;
  std::vector<Trial> corrected;
  for (const Contact& c : positive_contacts()) {
    const double definition = potential_by_definition(hertz, c);
    printed.push_back(relative(definition, pole_integral(c, [&](double r, double sigma) {
                                 return c.mu * sigma * std::abs(c.omega * r) * r;
                               })));
    corrected.push_back(relative(definition, pole_integral(c, [&](double r, double sigma) {
                                   return c.mu * sigma * std::abs(c.omega * r) * std::abs(r);
                                 })));
  }
  const Trial p = worst(printed);
  const Trial k = worst(corrected);
  return {p, k, nested,
          "u <= 1: with r dr the integral is " + text(p.obtained, 2) + " W instead of " + text(p.expected) +
              " W, with |r| dr relative error " + text(k.error, 2) + ". The line for u > 1 holds to " +
              text(printed.back().error, 2)};
}

Finding pole_potential_members() {
  std::vector<Trial> printed;
  std::vector<Trial> corrected;
  for (const Contact& c : positive_contacts()) {
    const double definition = potential_by_definition(hertz, c);
    const double front = 3 * c.mu * c.lambda_n / (2 * std::numbers::pi * c.radius * c.radius) * c.omega;
    const double mean = c.lambda_n / (std::numbers::pi * c.radius * c.radius);
    printed.push_back(
        relative(definition, front * pole_integral(c, [](double r, double sigma) { return sigma * r * r; })));
    // the square root of (3.4) in place of σ
    corrected.push_back(relative(definition, front * pole_integral(c, [&](double r, double sigma) {
                                               return sigma / (1.5 * mean) * r * r;
                                             })));
  }
  const Trial p = worst(printed);
  const Trial k = worst(corrected);
  return {p, k, nested,
          "Generic contact (R = 0.7 m, λ_N = 2.5 N): the middle member is " +
              text(p.obtained / p.expected, 10) +
              " times Φ (3λ_N/(2πR²) once too often); with the root of (3.4) in place of σ relative error " +
              text(k.error, 2)};
}

/// Q_2 of (3.8) by quadrature along the chord, q = u cos θ + h sin a.
Real q2(const Real& u, const Real& theta) {
  const Real m = u * cos(theta);
  // At u = 1, θ = π/2 the chord has no length; rounding must not make it imaginary.
  const Real h = sqrt(std::max(Real(0), Real(1 - pow(u * sin(theta), 2))));
  return integrate([&](const Real& a) -> Real { return pow(m + h * sin(a), 2) * h * h * cos(a) * cos(a); },
                   -pi() / 2, pi() / 2);
}

/// The same in double, for the outer integral over θ.
double q2_double(double u, double theta) {
  const double m = u * std::cos(theta);
  const double h = std::sqrt(std::max(0.0, 1 - std::pow(u * std::sin(theta), 2)));
  const auto along = [&](double a) { return std::pow((m + h * std::sin(a)) * h * std::cos(a), 2); };
  return integrate_double(along, -std::numbers::pi / 2, std::numbers::pi / 2);
}

Finding last_members() {
  std::vector<Trial> trials;
  const double half_pi = std::numbers::pi / 2;
  for (const Real& argument : inner_arguments()) {
    const double u = static_cast<double>(argument);
    const auto chord = [&](double theta) { return q2_double(u, theta); };
    const double sum = integrate_double(chord, 0, half_pi) + integrate_double(chord, half_pi, 2 * half_pi);
    trials.push_back(relative(exact(hertz, argument).f, 1.5 / std::numbers::pi * sum));
  }
  for (const Real& argument : outer_arguments()) {
    const double u = static_cast<double>(argument);
    // sin θ = sin ψ/u takes the square-root end at θ* away
    const auto chord = [&](double psi) {
      const double theta = std::asin(std::sin(psi) / u);
      return q2_double(u, theta) * std::cos(psi) / (u * std::cos(theta));
    };
    trials.push_back(
        relative(exact(hertz, argument).f, 3 / std::numbers::pi * integrate_double(chord, 0, half_pi)));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          nested,
          "3/(2π) ∫Q_2 dθ and 3/π ∫Q_2 dθ against the law, u = 0.05 to 10: largest relative difference " +
              text(t.error, 2)};
}

Finding radial_limits() {
  std::vector<Trial> printed;
  std::vector<Trial> corrected;
  for (const Contact& c : positive_contacts()) {
    if (c.u() >= 1) continue;
    const double critical = unsigned_pole(c);
    for (const double theta : {0.4, 1.1, 2.0}) {
      const auto rho_at = [&](double r) {
        const auto [x, y] = from_pole(r, theta, critical);
        return std::hypot(x, y);
      };
      const double root = std::sqrt(c.radius * c.radius - std::pow(critical * std::sin(theta), 2));
      for (const int side : {-1, 1}) {
        corrected.push_back(relative(c.radius, rho_at(critical * std::cos(theta) + side * root)));
      }
      // As printed r stands on both sides; the equation r = r cos
      // θ + √(R*² − r² sin²θ) has the solution R*/(2 sin(θ/2)).
      printed.push_back(relative(c.radius, rho_at(critical / (2 * std::sin(theta / 2)))));
    }
  }
  const Trial p = worst(printed);
  const Trial k = worst(corrected);
  return {p, k, 1e-14,
          "ρ at r±, which should be R = 0.7: as printed (solved for r) up to " + text(p.obtained) +
              ", corrected to " + text(k.error, 2)};
}

Finding normalised_limits() {
  std::vector<Trial> trials;
  for (const char* number : {"0.4", "1", "1.7"}) {
    const Real u(number);
    for (const char* angle : {"0.1", "0.4", "0.6"}) {
      const Real theta(angle);
      const Real root = sqrt(1 - pow(u * sin(theta), 2));
      for (const int side : {-1, 1}) {
        const Real q = u * cos(theta) + side * root;
        trials.push_back(absolute(0, -q * q + 2 * q * u * cos(theta) + 1 - u * u));
      }
    }
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "The root of (3.4) vanishes at q±, 18 points, to " + text(t.error, 2)};
}

Finding q2_definition() {
  std::vector<Trial> trials;
  for (const char* number : {"0.4", "1.3"}) {
    const Real u(number);
    const Real theta = ratio(1, 2);
    const Real m = u * cos(theta);
    const Real h = sqrt(1 - pow(u * sin(theta), 2));
    // In q itself; its ends are square roots, which the rule resolves to half its digits.
    const Real direct = integrate(
        [&](const Real& q) -> Real {
          return q * q * sqrt(std::max(Real(0), Real(-q * q + 2 * q * u * cos(theta) + 1 - u * u)));
        },
        m - h, m + h);
    trials.push_back(relative(q2(u, theta), direct));
  }
  const Trial t = worst(trials);
  return {t, {}, 1e-20, "As printed, in q, against the chord variable of (3.11)'s rows: " + text(t.error, 2)};
}

/// The four lines of (3.11), each with its arcsine at the limits.
std::array<Real, 4> lines_of_q2(const Real& u, const Real& theta) {
  const Real s2 = pow(sin(theta), 2);
  const Real a = -1;
  const Real b = 2 * u * cos(theta);
  const Real c = 1 - u * u;
  const Real delta = -4 * (1 - u * u * s2);
  const Real root = sqrt(1 - u * u * s2);
  // The arguments at q± are ∓1 up to rounding.
  const auto arcsine = [](const Real& x) { return asin(std::clamp(x, Real(-1), Real(1))); };
  const auto between = [&](auto argument) -> Real {
    return arcsine(argument(u * cos(theta) + root)) - arcsine(argument(u * cos(theta) - root));
  };
  const Real line1 = -(5 * b * b - 4 * a * c) / (16 * a * a) * delta / (8 * a) / sqrt(-a) *
                     between([&](const Real& q) -> Real { return (2 * a * q + b) / sqrt(-delta); });
  const Real line2 = (5 * b * b + 4 * c) * delta / 128 *
                     between([&](const Real& q) -> Real { return (-2 * q + b) / sqrt(-delta); });
  const Real line3 = -(4 * u * u - 5 * u * u * s2 + 1) * (1 - u * u * s2) / 8 *
                     between([&](const Real& q) -> Real { return (-q + u * cos(theta)) / root; });
  const Real line4 = pi() / 8 * (5 * pow(u, 4) * s2 * s2 - (4 * pow(u, 4) + 6 * u * u) * s2 + 1 + 4 * u * u);
  return {line1, line2, line3, line4};
}

Finding q2_line(std::size_t first, std::size_t last) {
  std::vector<Trial> trials;
  for (const char* number : {"0.4", "0.95", "1.3", "8"}) {
    const Real u(number);
    for (const char* angle : {"0.01", "0.06", "0.12"}) {
      const Real theta(angle);
      const Real value = q2(u, theta);
      const auto lines = lines_of_q2(u, theta);
      for (std::size_t i = first; i <= last; ++i) trials.push_back(relative(value, lines[i]));
    }
  }
  const Trial t = worst(trials);
  // arcsin at ±1 turns a rounding of 1e-50 into its root.
  return {t,
          {},
          1e-22,
          "Against quadrature of (3.8) at 12 pairs (u, θ): largest relative difference " + text(t.error, 2)};
}

/// The bracket of (3.12) and (3.13) integrated.
Real bracket(const Real& u, const Real& theta) {
  const Real s2 = pow(sin(theta), 2);
  return 5 * pow(u, 4) * s2 * s2 - (4 * pow(u, 4) + 6 * u * u) * s2 + 1 + 4 * u * u;
}

Finding inner_potential_lines() {
  std::vector<Trial> trials;
  for (const Real& u : inner_arguments()) {
    const Real f = exact(hertz, u).f;
    trials.push_back(
        relative(f, ratio(3, 16) * integrate([&](const Real& t) { return bracket(u, t); }, 0, pi())));
    trials.push_back(relative(f, 3 * pi() / 16 * (-pow(u, 4) / 8 + u * u + 1)));
  }
  const Trial t = worst(trials);
  return {t,
          {},
          digits50,
          "Both lines against the law, u = 0.05 to 1: largest relative difference " + text(t.error, 2)};
}

Finding outer_potential_line(int line) {
  std::vector<Trial> trials;
  for (const Real& u : outer_arguments()) {
    const Real theta = asin(1 / u);
    const Real u2 = u * u;
    const Real u4 = u2 * u2;
    Real sum;
    switch (line) {
      case 1:
        sum = integrate([&](const Real& t) { return bracket(u, t); }, 0, theta);
        break;
      case 2:
        sum = 5 * u4 * (3 * theta / 8 - sin(2 * theta) / 4 + sin(4 * theta) / 32) -
              (4 * u4 + 6 * u2) * (theta / 2 - sin(2 * theta) / 4) + (1 + 4 * u2) * theta;
        break;
      case 3:
        sum = (-u4 / 8 + u2 + 1) * theta + (-u4 / 4 + 3 * u2 / 2) * sin(2 * theta) +
              5 * u4 / 32 * sin(4 * theta);
        break;
      default:
        sum = (-u4 / 8 + u2 + 1) * theta + (u2 / 8 + ratio(7, 4)) * sqrt(u2 - 1);
        break;
    }
    trials.push_back(relative(exact(hertz, u).f, ratio(3, 8) * sum));
  }
  const Trial t = worst(trials);
  return {
      t, {}, digits50, "Against the law, u = 1.1, 1.7, 10: largest relative difference " + text(t.error, 2)};
}

Finding outer_potential_lines() {
  std::vector<Trial> trials;
  for (int line = 1; line <= 4; ++line) trials.push_back(outer_potential_line(line).printed);
  const Trial t = worst(trials);
  return {
      t,
      {},
      digits50,
      "All four lines against the law, u = 1.1, 1.7, 10: largest relative difference " + text(t.error, 2)};
}

Finding sines() {
  std::vector<Trial> trials;
  for (const Real& u : outer_arguments()) {
    const Real theta = asin(1 / u);
    const Real root = sqrt(u * u - 1);
    trials.push_back(relative(sin(2 * theta), 2 / (u * u) * root));
    trials.push_back(relative(sin(4 * theta), 4 / (u * u) * (1 - 2 / (u * u)) * root));
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "u = 1.1, 1.7, 10: largest relative difference " + text(t.error, 2)};
}

Finding law_printed(const std::function<Real(const Real&)>& printed, Real Exact::*member) {
  std::vector<Trial> trials;
  for (const auto& arguments : {inner_arguments(), outer_arguments()}) {
    for (const Real& u : arguments) trials.push_back(relative(exact(hertz, u).*member, printed(u)));
  }
  const Trial t = worst(trials);
  return {t, {}, digits50, "u = 0.05 to 10, in 50 digits: largest relative difference " + text(t.error, 2)};
}

Finding set_valued_definition() {
  std::vector<Trial> off_rest;
  for (const auto& arguments : {inner_arguments(), outer_arguments()}) {
    for (const Real& u : arguments) {
      if (u == 1) continue;
      // Φ/(μλ_N) = s f(v/s): slopes in v and in s by five-point differences, h = 1e-9: h⁴ and 1e-49/h
      const Real h = Real("1e-9");
      const auto phi = [](const Real& v, const Real& s) -> Real { return s * potential_printed(v / s); };
      const auto slope = [&](auto at) -> Real {
        return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
      };
      const Exact e = exact(hertz, u);
      off_rest.push_back(relative(e.xi, slope([&](const Real& d) { return phi(u + d, 1); })));
      off_rest.push_back(relative(e.eta, slope([&](const Real& d) { return phi(u, 1 + d); })));
    }
  }
  const Trial corrected = worst(off_rest);
  const Real along_spin = exact(hertz, ratio(1, 1000000)).xi;
  const Real along_slide = exact(hertz, 1000000).xi;
  return {absolute(along_spin, along_slide), corrected, 1e-30,
          "∇_{|v|}Φ/(μλ_N) at the origin: " + text(along_spin, 3) + " along v/γ_τ = 1e-6, " +
              text(along_slide, 12) +
              " along 1e6. Off the origin the slopes of (3.14) are the integrated force and torque, to " +
              text(corrected.error, 2)};
}

Finding plate(bool ball) {
  const auto length = [&](const Real& xi) {
    return ball ? Real(sqrt(pow(xi * cos(Real(2)), 2) + pow(xi * sin(Real(2)), 2))) : xi;
  };
  const auto inner = [&](const Real& sixth) {
    return order(
        [&](const Real& u) {
          const Exact e = exact(hertz, u);
          return Real(plate_inner_side(length(e.xi), e.eta, sixth) - 1);
        },
        8);
  };
  const Trial outer = order(
      [&](const Real& w) {
        const Exact e = exact(hertz, 1 / w);
        return Real(plate_outer_side(length(e.xi), e.eta) - 1);
      },
      8);
  const Trial printed = inner(ratio(9, 32768));
  const Trial corrected = inner(ratio(729, 32768));
  return {worst({printed, outer}), worst({corrected, outer}), order_bound,
          "On the exact border the inner left side differs from 1 with the power " + text(printed.obtained) +
              " of ξ as printed, " + text(corrected.obtained) + " with 729/32768; the outer with the power " +
              text(outer.obtained) + " of η. Exact elimination, after 9/64 (η/η*)² and ξ²: " +
              text(plate_inner(hertz_inner(6))) + "; " + text(plate_outer(hertz_outer(6)))};
}

Finding plate_seam() {
  const auto jump = [](const Real& sixth) {
    const Real below = seam_eta() * sqrt((1 - plate_inner_side(seam_xi(), 0, sixth)) * 64 / 9);
    Real low = 0;
    Real high = ratio(1, 2);
    for (int i = 0; i < 160; ++i) {
      const Real eta = (low + high) / 2;
      (plate_outer_side(seam_xi(), eta) < 1 ? low : high) = eta;
    }
    return std::array<Real, 2>{below, low};
  };
  const auto printed = jump(ratio(9, 32768));
  const auto corrected = jump(ratio(729, 32768));
  const Real step = Real(1e-20);
  const Trial exact_jump = absolute(exact(hertz, 1 - step).eta, exact(hertz, 1 + step).eta);
  return {absolute(printed[0], printed[1]), exact_jump, 1e-19,
          "η at ξ*: as printed " + text(printed[0], 7) + " inside, " + text(printed[1], 7) +
              " outside, a step of " + text(printed[1] - printed[0], 3) + "; with 729/32768 a step of " +
              text(corrected[1] - corrected[0], 3) + ". Exact η* = 9π/128 = " + text(seam_eta(), 7)};
}

Finding seam_values() {
  const Exact e = exact(hertz, 1);
  const Trial t = worst({relative(e.xi, seam_xi()), relative(e.eta, seam_eta())});
  return {t,
          {},
          digits50,
          "ξ(1), η(1) of the law: " + text(e.xi, 12) + ", " + text(e.eta, 12) + "; relative difference " +
              text(t.error, 2)};
}

Finding normalised_forces() {
  std::vector<Trial> trials;
  for (const Contact& c : contacts()) {
    const Real u = Real(std::abs(c.v)) / (std::abs(c.omega) * c.radius);
    const Exact e = exact(hertz, u);
    trials.push_back(
        relative(potential_by_definition(hertz, c),
                 c.mu * c.lambda_n * (e.xi * std::abs(c.v) + e.eta * std::abs(c.omega) * c.radius)));
  }
  const Trial t = worst(trials);
  return {t, {}, nested, "μλ_N(ξ‖γ_T‖ + η|γ_τ|) = Φ of (2.1) for 10 contacts, to " + text(t.error, 2)};
}

Finding torque_pair() {
  const Contact c;
  const double torque = 0.37;
  const Trial t = relative(torque * c.omega, torque / c.radius * (c.omega * c.radius));
  return {t, {}, 1e-15, "λ_τγ_τ = τ_Nω, to " + text(t.error, 2)};
}

Finding normal_cone() {
  std::vector<Exact> border;
  for (int i = 0; i <= 40; ++i) border.push_back(exact(hertz, tan(pi() / 2 * (2 * i + 1) / 83)));
  Real largest = -1;
  for (const char* number : {"0.05", "0.6", "1", "1.7", "30"}) {
    const Real u(number);
    const Exact e = exact(hertz, u);
    for (const Exact& b : border) {
      for (int k = 0; k < 8; ++k) {
        for (const int side : {-1, 1}) {
          const Real b1 = b.xi * cos(pi() * k / 4);
          largest = std::max(largest, Real(-u * (b1 + e.xi) - (side * b.eta + e.eta)));
        }
      }
    }
  }
  return {
      at_most_zero(largest),
      {},
      digits50,
      "λ_F of the law at u = 0.05 to 30 against 656 points b of the ball: the largest −γ_F·(b − λ_F) is " +
          text(largest, 3) + " (must be <= 0)"};
}

}  // namespace

std::vector<Row> section3() {
  return {
      {"3.1", "(3.1)", "ρ cos φ = r sin θ, ρ sin φ + r cos θ = R* = |v/ω|", Flaw::imprecise,
       "ρ sin φ + r cos θ = v/ω",
       "The pole is the point at rest only for vω > 0; Φ is even in v and ω, so every result below stands.",
       pole_coordinates},
      {"3.2", "(3.2)", "R = (3ρ*λ_N/(4E*))^{1/3}, 1/ρ* = 1/ρ_1 + 1/ρ_2", Flaw::none, "", "", contact_radius},
      {"3.3", "(3.3)", "1/E* = (1 − ν_1²)/E_1 + (1 − ν_2²)/E_2", Flaw::none, "",
       "The text calls ν_i Poisson constants; they are Poisson's ratios.", effective_modulus},
      {"3.4", "(3.4)", "σ = 3λ_N/(2πR²) √(1 − ρ²/R²) = 3λ_N/(2πR²) √(−q² + 2qu cos θ + 1 − u²)", Flaw::none,
       "", "", pressure_members},
      {"3.5", "(3.5)", "‖w‖ = √((v − ωρ sin φ)² + (ωρ cos φ)²) = |ωr|", Flaw::imprecise,
       "the same with the pole of (3.1) at v/ω", "True as printed for vω > 0.", speed},
      {"3.6", "(3.6)", "Φ = ∫_0^π ∫_{r−}^{r+} μσ‖w‖ r dr dθ, u <= 1; 2 ∫_0^{θ*} ∫ μσ‖w‖ r dr dθ, u > 1",
       Flaw::misprint, "|r| dr for u <= 1",
       "As printed the two halves of each chord cancel and Φ = 0. (3.7) goes on correctly.", pole_potential},
      {"3.7", "(3.7)", "middle members 3μλ_N/(2πR²) |ω| ∫∫ σ r² dr dθ and 3μλ_N/(πR²) |ω| ∫∫ σ r² dr dθ",
       Flaw::misprint, "√(1 − ρ²/R²) in place of σ (or the factor μ alone)",
       "The dimension is wrong as printed.", pole_potential_members},
      {"3.7.last", "(3.7), last members", "3μλ_N/(2π) R|ω| ∫_0^π Q_2 dθ; 3μλ_N/π R|ω| ∫_0^{θ*} Q_2 dθ",
       Flaw::none, "", "", last_members},
      {"3.8", "(3.8)", "Q_2 = ∫_{q−}^{q+} √(−q² + 2qu cos θ + 1 − u²) q² dq", Flaw::none, "", "",
       q2_definition},
      {"3.9", "(3.9)", "r± = r cos θ ± √(R*² − r² sin²θ)", Flaw::misprint,
       "r± = R* cos θ ± √(R² − R*² sin²θ)", "(3.10) is the correct one divided by R.", radial_limits},
      {"3.10", "(3.10)", "q± = u cos θ ± √(1 − u² sin²θ)", Flaw::none, "", "", normalised_limits},
      {"3.11", "(3.11)", "Q_2 in four lines", Flaw::none, "", "", [] { return q2_line(0, 3); }},
      {"3.11.line1", "(3.11) line 1", "−(5b² − 4ac)/(16a²) Δ/(8a) (1/√−a) [arcsin((2aq + b)/√−Δ)]",
       Flaw::none, "", "", [] { return q2_line(0, 0); }},
      {"3.11.line2", "(3.11) line 2", "(5b² + 4c)Δ/128 [arcsin((−2q + b)/√−Δ)]", Flaw::none, "", "",
       [] { return q2_line(1, 1); }},
      {"3.11.line3", "(3.11) line 3",
       "−(4u² − 5u² sin²θ + 1)(1 − u² sin²θ)/8 [arcsin((−q + u cos θ)/√(1 − u² sin²θ))]", Flaw::none, "", "",
       [] { return q2_line(2, 2); }},
      {"3.11.line4", "(3.11) line 4", "(π/8)(5u⁴ sin⁴θ − (4u⁴ + 6u²) sin²θ + 1 + 4u²)", Flaw::none, "", "",
       [] { return q2_line(3, 3); }},
      {"3.12", "(3.12)", "Φ = (3μλ_N/16) R|ω| ∫_0^π (...) dθ = (3μλ_N/16) R|ω| π(−u⁴/8 + u² + 1)", Flaw::none,
       "", "", inner_potential_lines},
      {"3.13", "(3.13)", "Φ for u > 1 in four lines", Flaw::none, "", "", outer_potential_lines},
      {"3.13.line1", "(3.13) line 1", "(3/8) ∫_0^{θ*} (5u⁴ sin⁴θ − (4u⁴ + 6u²) sin²θ + 1 + 4u²) dθ",
       Flaw::none, "", "", [] { return outer_potential_line(1); }},
      {"3.13.line2", "(3.13) line 2",
       "5u⁴(3θ*/8 − sin 2θ*/4 + sin 4θ*/32) − (4u⁴ + 6u²)(θ*/2 − sin 2θ*/4) + (1 + 4u²)θ*", Flaw::none, "",
       "", [] { return outer_potential_line(2); }},
      {"3.13.line3", "(3.13) line 3", "(−u⁴/8 + u² + 1)θ* + (−u⁴/4 + 3u²/2) sin 2θ* + (5/32)u⁴ sin 4θ*",
       Flaw::none, "", "", [] { return outer_potential_line(3); }},
      {"3.13.line4", "(3.13) line 4", "(−u⁴/8 + u² + 1)θ* + (u²/8 + 7/4)√(u² − 1)", Flaw::none, "", "",
       [] { return outer_potential_line(4); }},
      {"3.13.sines", "(3.13), text below",
       "sin θ* = 1/u, sin 2θ* = (2/u²)√(u² − 1), sin 4θ* = (4/u²)(1 − 2/u²)√(u² − 1)", Flaw::none, "", "",
       sines},
      {"3.14", "(3.14)",
       "Φ: (3μλ_N/128) R|ω|π(−u⁴ + 8u² + 8); (3μλ_N/64) R|ω|((−u⁴ + 8u² + 8) arcsin(1/u) + (u² + 14)√(u² − "
       "1))",
       Flaw::none, "", "In double precision the second line loses digits like u⁴ (accuracy table).",
       [] { return law_printed(potential_printed, &Exact::f); }},
      {"3.15", "(3.15)", "λ_τ = τ_N/R, γ_τ = ωR", Flaw::none, "", "", torque_pair},
      {"3.16", "(3.16)", "−λ_T ∈ ∂‖γ_T‖ ∇_{|v|}Φ, −λ_τ ∈ ∂|γ_τ| ∇_{|γ_τ|}Φ", Flaw::imprecise,
       "the same for γ_F ≠ 0 only; at γ_F = 0, −λ_F ∈ ∂Φ jointly",
       "As for (2.12): called the definition of the set-valued law, it does not define the set.",
       set_valued_definition},
      {"3.17", "(3.17)",
       "λ_T: (3μλ_N/32) πu(−u² + 4); (3μλ_N/16)(1/u)(u²(4 − u²) arcsin(1/u) + (u² + 2)√(u² − 1))", Flaw::none,
       "", "", [] { return law_printed(force_printed, &Exact::xi); }},
      {"3.18", "(3.18)",
       "λ_τ: (3μλ_N/128) π(3u⁴ − 8u² + 8); (3μλ_N/64)((3u⁴ − 8u² + 8) arcsin(1/u) + (−3u² + 6)√(u² − 1))",
       Flaw::none, "",
       "In double precision the second line loses digits like u⁴ relative to η ~ 1/u (accuracy table).",
       [] { return law_printed(torque_printed, &Exact::eta); }},
      {"3.19", "(3.19)",
       "(9/64)(η/η*)² + (9/8)(ξ/ξ*)² − (243/1024)(ξ/ξ*)⁴ − (9/32768)(ξ/ξ*)⁶ + ... <= 1; ξ² + 5η² − (75/7)η⁴ "
       "+ (1250/147)η⁶ + ... <= 1",
       Flaw::misprint, "−(729/32768)(ξ/ξ*)⁶; all other coefficients hold",
       "Moves the border by up to 9 % of η at the seam (plates.tsv).", [] { return plate(false); }},
      {"3.19.seam", "(3.19), the border at ξ*", "one set, with ξ <= ξ* and ξ > ξ*", Flaw::imprecise,
       "continuous only with all terms",
       "Cut after three terms the plate is neither convex nor closed at the seam, with either coefficient.",
       plate_seam},
      {"3.20", "(3.20)", "ξ = ‖λ_T‖/(μλ_N), η = λ_τ/(μλ_N)", Flaw::none, "", "", normalised_forces},
      {"3.20.seam", "(3.20), text below", "ξ* = 9π/32, η* = 9π/128", Flaw::none, "", "", seam_values},
      {"3.21", "(3.21)", "B_F: (3.19) with ξ = ‖λ_T‖/(μλ_N) of the two-vector λ_T", Flaw::misprint,
       "−(729/32768)(ξ/ξ*)⁶, as in (3.19)", "", [] { return plate(true); }},
      {"3.22", "(3.22)", "−γ_F ∈ N_{B_F}(λ_F)", Flaw::none, "", "", normal_cone},
  };
}

}  // namespace verify::ledger
