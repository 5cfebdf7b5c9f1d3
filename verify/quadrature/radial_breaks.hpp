#pragma once

#include <vector>

#include "pressure.hpp"

namespace verify {

/// Where to split a radial integral in t = arccos ρ over (0, π/2), ascending: at the breaks
/// of the pressure and around the pole. The mean over a ring has a logarithm in ρ − u, so
/// t* = arccos u is one such place. A pole close to the centre or to the edge (inside or
/// outside) makes a layer much thinner than the disc, which no adaptive rule finds if none
/// of its points falls into it: panels grow from the layer outwards, eightfold.
std::vector<double> radial_breaks(double u, const Pressure& pressure);

}  // namespace verify
