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
using AnyLaw = std::variant<UniformLaw, HertzLaw, PowerLaw, SeriesLaw, PrintedUniformLaw, PrintedHertzLaw, EllipsoidLaw,
                            DecoupledLaw, PadeLaw, TanhLaw>;

/// Pressures by name: "uniform", "hertz", "power:N" (N > -1).
/// Returns n of σ ∝ (1 − ρ²/R²)ⁿ; throws std::invalid_argument saying what was expected.
double pressure_exponent(std::string_view pressure);

/// Models by name: "exact"; "series" (as printed for uniform, four terms else), "series:K" (K terms); "printed" (the
/// paper's formulas to the letter: (2.13), (2.14) for uniform, (3.17), (3.18) for hertz); "ellipsoid"; "decoupled";
/// "pade", "pade2"; "tanh:EPS" (EPS in m/s).
/// Throws std::invalid_argument with one line that names the value and what was expected.
AnyLaw make_law(std::string_view pressure, std::string_view model = "exact");

/// One line a model, for --help.
std::string model_help();

}  // namespace contensou
