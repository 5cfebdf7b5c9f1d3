#pragma once

#include <filesystem>

#include "sheet.hpp"

/// One function a scene, or a few that have their mathematics in common. Runs are made with a tolerance of
/// 1e-12; a bound is what the steps can have added up to, one tolerance each, in the motion's scales, with
/// the answer's own 1e-11.
namespace verify::answers {

void check_tippe_top_bodies(Sheet& sheet);
/// Also scenes_limits.tsv (u* over κ) and scenes_disc.tsv (u over t).
void check_sliding_disc(const std::filesystem::path& folder, Sheet& sheet);
void check_polishing_machine(Sheet& sheet);
void check_sidespin(Sheet& sheet);
void check_bouncing_ball(Sheet& sheet);
void check_free_body(Sheet& sheet);
void check_corner(Sheet& sheet);
void check_pile(Sheet& sheet);

inline constexpr double oracle_error = 1e-11;
inline const std::string accurate = "integrator.tolerance=1e-12";

}  // namespace verify::answers
