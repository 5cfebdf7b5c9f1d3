#pragma once

#include "quantities.hpp"

namespace reference {

/// Uniform pressure (n = 0) in Arb's complete elliptic integrals K and E of parameter m = u² or u⁻², u ≠ 1, u
/// > 0. With D = (K−E)/m, B = K−D, C = (D−B)/m:
///   u < 1:  ξ/u = 4/(3π) [2B + (1−m) D],  η = 4/(9π) [(3−m) B + (1−m)(3−2m) D],  f'' = 4/(3π) [B + 2(1−m) D]
///   u > 1:  ξ = 4/(3π) [2B + (1−m) D],  u η = 4/(9π) [2B + (1−m) C],  u³ f'' = 4/(3π) (D − C)
/// The differences cancel up to m⁻² for small m; give it the bits for that.
Scaled uniform_closed_form(const Argument& at);

/// Hertz pressure (n = ½) in elementary functions: LG03 (3.17),
/// (3.18) for ξ and η, and the derivative of (3.17) for f'':
///   u <= 1: f'' = (3π/32) (4 − 3u²);  u > 1: f'' = (3/16) [(4 − 3u²) arcsin(1/u) + (3 − 2/u²) √(u² − 1)].
/// For u > 1 the terms cancel up to u⁶.
Scaled hertz_closed_form(const Argument& at);

}  // namespace reference
