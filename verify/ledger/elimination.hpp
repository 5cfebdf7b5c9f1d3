#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <string>
#include <vector>

/// The series of Sections 2 and 3 in exact rational arithmetic, derived from the chord integrals of
/// oracle.hpp term by term.
namespace verify::ledger {

using Rational = boost::multiprecision::cpp_rational;
using PowerSeries = std::vector<Rational>;

/// C(a, k) for rational a.
Rational binomial(const Rational& a, unsigned k);

/// ξ and η as series in t = u² (inner) or t = u⁻² (outer), stripped
/// of their odd factor and, so that all is rational, scaled:
///   uniform: ξ = u X(t), η = Y(t);  ξ = X(t), η = Y(t)/u
///   Hertz:   ξ = ξ* u X(t), η = η_max Y(t) with ξ* = 9π/32, η_max = 3π/16;  ξ = X(t), η = Y(t)/u
struct LawSeries {
  PowerSeries xi;
  PowerSeries eta;
};
LawSeries uniform_inner(std::size_t count);
LawSeries uniform_outer(std::size_t count);
LawSeries hertz_inner(std::size_t count);
LawSeries hertz_outer(std::size_t count);

/// The coefficients of f = uξ + η: uniform inner f_k of u^{2k}; outer f_k of u^{1−2k}.
PowerSeries potential_series(const LawSeries& law, bool inner);

/// c_1, c_2, ... of y + c_1 x + c_2 x² + ... = y_0, with x = t·(...) and y = y_0 + ... series in t.
PowerSeries eliminate(const PowerSeries& x, PowerSeries y);

/// The plate's coefficients, k = 1, 2, ...:
///   inner: (η/η_max)² + Σ c_k ξ^{2k} = 1 (Hertz: of (ξ/ξ*)^{2k}); outer: ξ² + Σ c_k η^{2k} = 1.
PowerSeries plate_inner(const LawSeries& law);
PowerSeries plate_outer(const LawSeries& law);

std::string text(const PowerSeries& series);

}  // namespace verify::ledger
