#pragma once

#include "rivals/closed_form.hpp"

namespace rivals {

/// Hertz pressure as printed: Φ from LG03 (3.14), ξ from (3.17), η from (3.18), each by its own formula, and
/// f″ the derivative of (3.17):
///   u <= 1: 3π/32 (4 − 3u²),   u > 1: 3/16 [(4 − 3u²) arcsin(1/u) + (3 − 2/u²) √(u² − 1)].
extern const ClosedForm printed_hertz;

/// Uniform pressure as printed: Φ from LG03 (2.8), ξ from (2.13), η from (2.14) without their O(...), and f″
/// the derivative of (2.13).
extern const ClosedForm printed_uniform;

}  // namespace rivals
