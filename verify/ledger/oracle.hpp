#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <functional>
#include <initializer_list>
#include <string>

#include "row.hpp"

/// What the ledger measures with. None of it comes from the
/// library: integrals of the definition, in 50 digits or in double.
namespace verify::ledger {

using Real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Function = std::function<Real(const Real&)>;

Real pi();
inline Real ratio(long long p, long long q) { return Real(p) / Real(q); }

/// ∫_a^b f by tanh-sinh quadrature in 50 digits, to a relative
/// tolerance; f may have algebraic singularities at a and b only.
Real integrate(const Function& f, const Real& a, const Real& b, const Real& tolerance = Real(1e-40));

/// ∫_a^b f in double, the same rule: for double integrals.
double integrate_double(const std::function<double(double)>& f, double a, double b);

/// Tolerances used again and again.
/// Of two closed forms, or a closed form and a 50-digit quadrature: 50 digits less the cancellation of the
/// formulas (u <= 10: u⁴ and a few small differences).
inline constexpr double digits50 = 1e-35;
/// Of a double integral in double: each rule stops at 1e-13
/// relative, a hundred times that for their nesting and sums.
inline constexpr double nested = 1e-11;
/// Of a central difference of nested integrals, step h = 1e-3 of the argument, five points: h⁴ and 1e-12/h.
inline constexpr double differenced = 1e-8;
/// Of the measured order of a remainder c xᵖ(1 + O(x²)) between x = 1/100 and x = 1/1000: log10(1 + O(1e-4)).
inline constexpr double order_bound = 0.01;

enum class Pressure { uniform, hertz };

/// The law from forces and torques of the surface elements, the chords through the pole of (3.1) done by
/// hand: with h the half chord, c = cos θ,
///   u <= 1: ξ = (4u/π) ∫c²h, η = 4/(3π) ∫h³ (uniform); ξ = (3u/2) ∫c²h², η = (3/8) ∫h⁴ (Hertz), θ from 0 to
///   π/2, h² = 1 − u² sin²θ; u > 1: the same with sin θ = sin ψ/u, h = cos ψ. f = Φ/(μλ_N|ω|R) = uξ + η.
/// The rows of (2.1), (2.2) and (3.4) check it against double integrals of the definition.
struct Exact {
  Real f;
  Real xi;
  Real eta;
};
Exact exact(Pressure pressure, const Real& u);

/// A contact in generic units, so that a wrong factor, power or dimension shows.
struct Contact {
  double mu = 0.3;
  double lambda_n = 2.5;
  double radius = 0.7;
  double v = 1.3;
  double omega = 2.9;
  double u() const;
};
/// Contacts with u below and above one, each sign of v and ω.
std::vector<Contact> contacts();
/// The same with v, ω > 0.
std::vector<Contact> positive_contacts();

/// σ(ρ) of the contact, uniform or as in the first member of (3.4).
double pressure_at(Pressure pressure, const Contact& contact, double rho);

/// ∫_0^{2π} ∫_0^R g(ρ, φ) ρ dρ dφ in double, split where
/// the sliding velocity vanishes, (ρ, φ) = (|v/ω|, ±π/2).
double over_disc(const Contact& contact, const std::function<double(double, double)>& g);

/// Φ of LG03 (2.1): ∬ μσ‖w‖ dA over the disc, directly.
double potential_by_definition(Pressure pressure, const Contact& contact);

// Trials.
Trial relative(const Real& expected, const Real& obtained);
Trial absolute(const Real& expected, const Real& obtained);
Trial worst(const std::vector<Trial>& trials);
/// The measured order p of remainder(x) ~ xᵖ for x → 0, against the order claimed.
Trial order(const Function& remainder, int claimed);
/// An inequality g <= 0 that is claimed: its violation.
Trial at_most_zero(const Real& g);

/// Numbers in evidence.
std::string text(const Real& x, int digits = 6);

}  // namespace verify::ledger
