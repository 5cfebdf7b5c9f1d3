#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "contensou/law/approximations.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/power.hpp"
#include "contensou/law/series.hpp"
#include "contensou/law/uniform.hpp"

namespace contensou {

/// Any law of the library that has a name. Visit once at the door, not for each evaluation.
using AnyLaw = std::variant<UniformLaw, HertzLaw, PowerLaw, SeriesLaw, PrintedUniformLaw, PrintedHertzLaw,
                            EllipsoidLaw, DecoupledLaw, PadeLaw, TanhLaw>;

/// Pressures by name: "uniform", "hertz", "power:N" (-1 < N <= 1e6, a plain decimal number).
/// Returns n of σ ∝ (1 − ρ²/R²)ⁿ; throws std::invalid_argument with one line that names the value and what
/// was expected, such as "power:-2: expected power:N with N > -1".
double pressure_exponent(std::string_view pressure);

/// Models by name:
/// "exact"       UniformLaw, HertzLaw, PowerLaw (the latter for every "power:N", also for N = 0 and 0.5)
/// "series"      PrintedUniformLaw for uniform, else SeriesLaw with four terms
/// "series:K"    SeriesLaw with K terms, 1 <= K <= 1000
/// "printed"     the paper's formulas to the letter: PrintedUniformLaw, PrintedHertzLaw; none for "power:N"
/// "ellipsoid"   EllipsoidLaw with the exact law's semi-axes
/// "decoupled"   DecoupledLaw with the exact law's semi-axes
/// "pade" "pade2"  PadeLaw of first and second order with the exact law's limits
/// "tanh:EPS"    TanhLaw with the exact law's semi-axes, EPS > 0 in m/s
/// Throws std::invalid_argument with one line that names the value and what was expected.
AnyLaw make_law(std::string_view pressure, std::string_view model = "exact");

/// One line a pressure and one line a model, for --help.
std::string pressure_help();
std::string model_help();

}  // namespace contensou
