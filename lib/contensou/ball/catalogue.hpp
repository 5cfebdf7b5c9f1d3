#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "contensou/ball/disk_plate.hpp"
#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/rectangle_plate.hpp"
#include "contensou/ball/series_plate.hpp"
#include "contensou/ball/smooth_plate.hpp"
#include "contensou/ball/tabulated_plate.hpp"

namespace contensou {

/// Any friction plate and ball that has a name. Visit once at the door, not for each projection.
using AnyPlate =
    std::variant<SmoothPlate<UniformLaw>, SmoothPlate<HertzLaw>, SmoothPlate<CompiledLaw>,
                 SmoothPlate<EllipsoidLaw>, TabulatedPlate, RectanglePlate, DiskPlate, SeriesPlate>;
using AnyBall = std::variant<FrictionBall<SmoothPlate<UniformLaw>>, FrictionBall<SmoothPlate<HertzLaw>>,
                             FrictionBall<SmoothPlate<CompiledLaw>>, FrictionBall<SmoothPlate<EllipsoidLaw>>,
                             FrictionBall<TabulatedPlate>, FrictionBall<RectanglePlate>,
                             FrictionBall<DiskPlate>, FrictionBall<SeriesPlate>>;

/// Pressures as in law/catalogue.hpp: "uniform", "hertz", "power:N". Models:
/// "exact"             SmoothPlate of the exact law
/// "table:N"           TabulatedPlate of the exact law, N cells a side, 4 to 256
/// "printed" "series"  the paper's plates to the letter, LG03 (2.18), (3.19), for uniform and hertz;
///                     "series" for another pressure: plate_series with three terms
/// "corrected"         the same with the right coefficients and seam: plate_series with three terms
/// "series:K"          plate_series with K terms, 1 to 40 (pressures up to N = 100)
/// "ellipsoid" "decoupled"  the ellipsoid, disk × interval, with the exact law's semi-axes
/// "disk"              Coulomb's disk: no friction torque
/// Throws std::invalid_argument with one line that names the value and what was expected; for the laws
/// "pade", "pade2" and "tanh:EPS", which have no friction ball, it says why.
AnyPlate make_plate(std::string_view pressure, std::string_view model = "exact");
AnyBall make_ball(std::string_view pressure, std::string_view model = "exact");

/// One line a model, for --help; pressures as pressure_help().
std::string ball_model_help();

}  // namespace contensou
