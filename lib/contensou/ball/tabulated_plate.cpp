#include "contensou/ball/tabulated_plate.hpp"

namespace contensou {

template class SmoothPlate<TabulatedLaw>;

}  // namespace contensou
