#include "contensou/ball/smooth_plate.hpp"

namespace contensou {

template class SmoothPlate<UniformLaw>;
template class SmoothPlate<HertzLaw>;
template class SmoothPlate<CompiledLaw>;
template class SmoothPlate<RadialLaw>;
template class SmoothPlate<EllipsoidLaw>;

}  // namespace contensou
