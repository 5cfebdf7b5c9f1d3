#pragma once

#include "contensou/ball/smooth_plate.hpp"
#include "contensou/law/tabulated.hpp"

namespace contensou {

/// The friction plate from a table, for laws that are slow to evaluate, where an error of
/// TabulatedLaw::error_bound() is good enough; the uniform and the Hertz law cost no more themselves. The
/// table has a convex potential of its own, whose plate this is, so everything said of SmoothPlate
/// (optimality to rounding, non-expansive, symmetric) holds for it too; only the set is a slightly different
/// one, nowhere further from the law's than the largest difference of the potentials.
using TabulatedPlate = SmoothPlate<TabulatedLaw>;

extern template class SmoothPlate<TabulatedLaw>;

}  // namespace contensou
