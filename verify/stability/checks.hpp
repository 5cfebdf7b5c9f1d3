#pragma once

#include <filesystem>

#include "contensou/system/spinning_top_stability.hpp"
#include "record.hpp"
#include "slipping_top.hpp"

namespace verify::stability {

/// What the library's closed forms need to know of a top on one of its spheres.
contensou::SpinningPosition position(const Setting& setting);
/// ε of the library.
double damping(const Setting& setting, double spin);
/// η(0)μmgR, the drilling torque, from the extent of the law [N m].
double drilling_torque(const Setting& setting);

/// (5.22) to (5.37), one by one.
void check_equations(Record& record);
/// The statements on Regions I to IV and on what does not depend on ε, over a grid.
void check_regions(Record& record);
/// Rates of growth in the nonlinear simulation, over R: stability_growth.tsv.
void check_growth(const std::filesystem::path& folder, Record& record);
/// Points of Magnus's diagram by nonlinear simulation: fig11_simulated.tsv.
void check_points(const std::filesystem::path& folder, Record& record);

}  // namespace verify::stability
