#include <cmath>
#include <cstdio>
#include <numbers>

#include "about_centre.hpp"
#include "about_pole.hpp"
#include "checks.hpp"
#include "comparison.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"

namespace verify {
namespace {

using std::numbers::pi;

/// A double integral over lines through the pole, ∫_0^end ∫_{q⁻(θ)}^{q⁺(θ)} g(q, θ) dq dθ, to the letter: no
/// pairing, no symmetry, no substitution. `g` may change sign, so tolerances are absolute.
template <class Limits, class G>
double over_lines(double end, const Limits& limits, const G& g) {
  Adaptive lines(outer_tolerance, outer_tolerance);
  Adaptive chords(inner_tolerance, inner_tolerance);
  return lines
      .integrate(
          [&](double theta) {
            const auto [from, to] = limits(theta);
            return chords.integrate([&](double q) { return g(q, theta); }, from, to, {0.0}).value;
          },
          0, end)
      .value;
}

struct Interval {
  double from;
  double to;
};

/// σ of (3.4) in (q, θ) for R = λ_N = 1.
double hertz_pressure(double u, double q, double theta) {
  const double complement = -q * q + 2 * q * u * std::cos(theta) + 1 - u * u;
  return complement > 0 ? 3 / (2 * pi) * std::sqrt(complement) : 0;
}

/// (3.10).
Interval limits_310(double u, double theta) {
  const double half = std::sqrt(std::fmax(0.0, 1 - u * u * std::sin(theta) * std::sin(theta)));
  return {u * std::cos(theta) - half, u * std::cos(theta) + half};
}

/// The distance from the centre of the point (q, θ), (3.1).
double rho_of(double u, double q, double theta) {
  return std::hypot(q * std::sin(theta), u - q * std::cos(theta));
}

/// Both tolerances are absolute there, on potentials of about 1/2.
constexpr double letter_bound = 4 * quadrature_bound;

void check_measure(Record& record) {
  const double u = 0.5;
  const double phi = AboutCentre(power_pressure(0.5))(Quantity::potential, u).value;
  const auto limits = [u](double theta) { return limits_310(u, theta); };
  const auto to_letter = [&](auto measure) {
    return over_lines(pi, limits, [&](double q, double theta) {
      return hertz_pressure(u, q, theta) * std::abs(q) * measure(q);
    });
  };
  Comparison printed;
  printed.add(u, phi, to_letter([](double q) { return q; }), letter_bound);
  record.add(printed.claim(
      "quadrature.printed.3_6_measure", "LG03 (3.6)",
      "(3.6) to the letter for u <= 1, ||w|| = |omega r| with the signed measure r dr, is the potential "
      "(it vanishes: the two halves of each line cancel)",
      false));
  Comparison corrected;
  corrected.add(u, phi, to_letter([](double q) { return std::abs(q); }), letter_bound);
  record.add(corrected.claim("quadrature.corrected.3_6_measure", "LG03 (3.6) corrected",
                             "(3.6) with the measure |r| dr is the potential"));
  Comparison member;
  member.add(u, phi, 3 / (2 * pi) * to_letter([](double q) { return std::abs(q); }), letter_bound);
  record.add(member.claim(
      "quadrature.printed.3_7_middle", "LG03 (3.7), middle member",
      "the middle member of (3.7), 3 mu lambda_N |omega|/(2 pi R^2) times the integral of sigma r^2, "
      "is the potential (it holds the pressure's factor twice; R = 1 m, lambda_N = 1 N)",
      false));
  Comparison outer;
  for (const double x : {1.2, 3.0}) {
    const double whole = AboutCentre(power_pressure(0.5))(Quantity::potential, x).value;
    // q² √(...) between the roots is q² times a half-circle:
    // smooth but for the ends, where QAGS expects roots.
    const double right =
        3 / pi *
        over_lines(
            std::asin(1 / x), [x](double theta) { return limits_310(x, theta); },
            [x](double q, double theta) { return 2 * pi / 3 * hertz_pressure(x, q, theta) * q * q; });
    outer.add(x, whole, right, 2 * x * letter_bound);
  }
  record.add(outer.claim(
      "quadrature.printed.3_7_right", "LG03 (3.7), right member, (3.8), (3.10)",
      "the right member of (3.7) with Q_2 of (3.8) and the limits (3.10) is the potential for u > 1"));
}

void check_limits(Record& record) {
  // Do the limits lie on the edge ρ = R? (3.9) names the variable of integration in its own limits; read with
  // r as the contact radius, it is R cos θ ± √(R*² − R² sin² θ).
  double printed = 0;
  double corrected = 0;
  int real = 0;
  const double u = 1.5;
  const double theta_star = std::asin(1 / u);
  for (int i = 0; i < 64; ++i) {
    const double theta = theta_star * i / 64;
    const Interval right = limits_310(u, theta);
    const double root = u * u - std::sin(theta) * std::sin(theta);
    for (const double sign : {-1.0, 1.0}) {
      const double wrong = std::cos(theta) + sign * std::sqrt(root);
      printed = std::fmax(printed, std::abs(rho_of(u, wrong, theta) - 1));
      corrected = std::fmax(corrected, std::abs(rho_of(u, sign < 0 ? right.from : right.to, theta) - 1));
      ++real;
    }
  }
  // Near θ* the root halves the digits of its argument; then
  // ρ is stationary along the line, which doubles them again.
  constexpr double geometry_bound = 64 * 0x1p-52;
  const std::string sentence =
      " lie on the edge: largest |rho/R - 1| over " + std::to_string(real) + " points, u = 1.5";
  record.add(Claim{"quadrature.printed.3_9", "LG03 (3.9)",
                   "the limits as printed, r cos(theta) -+ sqrt(R*^2 - r^2 sin^2 theta) with r read as the "
                   "contact radius," +
                       sentence,
                   0, printed, printed, geometry_bound, false});
  record.add(Claim{"quadrature.corrected.3_9", "LG03 (3.9) corrected, (3.10)",
                   "the limits R* cos(theta) -+ sqrt(R^2 - R*^2 sin^2 theta)" + sentence, 0, corrected,
                   corrected, geometry_bound, true});
}

void check_sensitivity(Record& record) {
  const double u = 0.7;
  AboutCentre uniform(power_pressure(0));
  const double xi = uniform(Quantity::force, u).value;
  const double ours = contensou::UniformLaw{}.at(u, 1).xi;

  Comparison viscous;  // dλ_T = μσ dA ‖w‖, along w: the force would be ∬ σ w dA = v e_1
  viscous.add(u, xi, u, quadrature_bound);
  record.add(viscous.claim(
      "quadrature.printed.element", "LG03 2.2, sentence before (2.1)",
      "d lambda_T = mu sigma dA ||w|| is Coulomb's law on an element (it is viscous: the force would be "
      "proportional to v, and the unit is W)",
      false));
  Comparison disturbed;
  disturbed.add(u, xi, ours * (1 + 1e-11), quadrature_bound + 1e-13);
  record.add(disturbed.claim("quadrature.mutation.last_digits", "verify/quadrature",
                             "a law off by one part in 1e11 passes the bound of the comparisons", false));
  Comparison exchanged;
  exchanged.add(u, xi, contensou::HertzLaw{}.at(u, 1).xi, quadrature_bound + 1e-13);
  record.add(exchanged.claim("quadrature.mutation.pressure", "verify/quadrature",
                             "the Hertz law passes for the uniform law", false));
  Comparison sign;  // (2.8) with the sign of its u⁴ term turned
  const double phi = uniform(Quantity::potential, 0.01).value;
  const double x = 1e-4;
  sign.add(0.01, phi, 2.0 / 3 + x / 2 + x * x / 32 - x * x * x / 384, quadrature_bound + x * x * x * x);
  record.add(sign.claim("quadrature.mutation.coefficient", "verify/quadrature",
                        "(2.8) with the sign of its u^4 term turned passes at u = 0.01", false));
}

}  // namespace

int check_printed_steps() { return 3; }

void check_printed(Record& record, Progress& progress) {
  check_measure(record);
  progress.advance();
  check_limits(record);
  progress.advance();
  check_sensitivity(record);
  progress.advance();
  progress.clear();
  std::printf("printed formulas and mutations: see claims quadrature.printed.*, .corrected.*, .mutation.*\n");
}

}  // namespace verify
