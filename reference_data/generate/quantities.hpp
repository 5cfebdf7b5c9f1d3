#pragma once

#include "ball.hpp"

namespace reference {

/// The law at one u, in units of μλ_N, scaled so that nothing vanishes or blows up on its way to u = 0 or u =
/// ∞: for u <= 1 force = ξ/u, torque = η, second = f''; for u > 1 force = ξ, torque = u η, second = u³ f''.
struct Scaled {
  Ball force;
  Ball torque;
  Ball second;
};

/// u and what it is compared with 1, exactly: the double
/// itself, m = min(u, 1/u)², and 1 - m without cancellation.
struct Argument {
  Argument(double u_in, long bits)
      : value(u_in),
        u(u_in, bits),
        inner(u_in <= 1),
        m(inner ? u * u : 1.0 / (u * u)),
        complement(inner ? (1.0 - u) * (1.0 + u) : (u - 1.0) * (u + 1.0) * m) {}

  double value;
  Ball u;
  bool inner;
  Ball m;
  Ball complement;
};

}  // namespace reference
