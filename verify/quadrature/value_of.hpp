#pragma once

#include "contensou/law/friction_law.hpp"
#include "reduced_integrals.hpp"

namespace verify {

/// What a law of the library says of a quantity at v = u, s = 1.
template <contensou::FrictionLaw L>
double value_of(const L& law, Quantity quantity, double u) {
  switch (quantity) {
    case Quantity::potential:
      return contensou::potential(law, u, 1.0);
    case Quantity::force:
      return law.at(u, 1.0).xi;
    case Quantity::torque:
      return law.at(u, 1.0).eta;
    case Quantity::curvature:
      return law.curvature(u, 1.0).vv;
    case Quantity::load:
      break;
  }
  return 1;
}

}  // namespace verify
