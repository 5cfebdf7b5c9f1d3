#pragma once

#include <string>

#include "contensou/scene/audit.hpp"

namespace cli {

/// The audit as a drawing, SVG 1.1: a line for each variant, with its time and the relative change of each of
/// the first outcomes on logarithmic axes. Needs no other program.
std::string audit_picture(const contensou::Audit& audit, const contensou::Scene& scene);

}  // namespace cli
