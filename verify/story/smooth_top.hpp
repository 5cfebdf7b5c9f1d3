#pragma once

#include <functional>

#include "contensou/law/friction_law.hpp"
#include "run.hpp"

namespace verify::story {

/// The tippe-top of LG03 5.4 without sets, in the manner of Friedl (1997) as LG03 describes it: a floor that
/// gives way,
///     λ_N = max(0, −k g_N − d γ_N),
/// and friction that is a function of the velocity, λ_T = −μλ_N ξ γ_T/‖γ_T‖, λ_τ = −μλ_N η sgn γ_τ. It has no
/// contact problems to solve, and so takes friction of any kind.
struct SmoothTop {
  std::function<contensou::Friction(double v, double s)> friction;
  double sink = 1e-6;  ///< mg/k: how deep the top at rest sinks in [m]; d = 2√(km)
  double tolerance = 1e-8;
  double duration = 6;
};
/// The start of LG03 5.4, touching. Without events; report.status says whether it reached the end.
Curve follow(const SmoothTop& top, double interval = 1e-3);

}  // namespace verify::story
