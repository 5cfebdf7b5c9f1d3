#pragma once

#include <string>

#include "contensou/integrate/motion.hpp"
#include "contensou/output/table.hpp"
#include "contensou/system/tippe_top_axis.hpp"

/// The motion of LG03 5.4 as the figures and the animation draw it.
namespace reproduce {

/// Of the local error of a step. What becomes of it until a sample is read:
/// tests/figures/compare_motions.cpp.
constexpr double motion_tolerance = 1e-12;
constexpr double motion_end = 8;  ///< [s], LG03 Figs. 9, 10 and 12

enum class Pressure { hertz, uniform };

/// LG03's top; R [m] of both contacts.
contensou::TippeTopAxis tippe_top(Pressure pressure, double radius = 5e-4);

/// From LG03's initial state, touching the floor, by `event_driven`; `seen` is called every `interval` [s].
/// Throws std::runtime_error where the integration does not come to the end.
contensou::RunReport move_tippe_top(const contensou::TippeTopAxis& top, double interval,
                                    const contensou::Observer& seen, double t_end = motion_end);

/// Columns `run`, t, event, contact: of the events of a run those that leave a trace in a drawing. Impacts
/// shortly before their accumulation are left out.
contensou::Table event_table(const std::string& figure, const std::string& what);
void add_events(contensou::Table& table, const std::string& run, const contensou::RunReport& report);

/// An empty table of a motion: curve_table (curves.hpp) with how it was integrated.
contensou::Table motion_table(const std::string& figure, const std::string& what, const std::string& units,
                              std::vector<std::string> columns);

}  // namespace reproduce
