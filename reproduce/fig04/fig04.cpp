// Figure 4: the friction ball B_F of a uniform pressure: the friction plate turned about the λ_τ axis. On it
// the meridians, on the reader's side, of the ball as LG03 (2.19) prints it.

#include <cmath>
#include <numbers>

#include "../common/curves.hpp"
#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/plate_series.hpp"
#include "contensou/ball/smooth_plate.hpp"

namespace {

constexpr double size = 1;  // μλ_N, the unit of the forces
constexpr int meridians = 48;

double azimuth(int meridian) { return 2 * std::numbers::pi * meridian / meridians; }

void exact_ball(const std::filesystem::path& folder) {
  contensou::Table table = reproduce::curve_table(
      "4", "the friction ball B_F, meshed by meridians and parallels", "forces in μλ_N",
      "UniformLaw, its friction ball", {"meridian", "lambda_t1", "lambda_t2", "lambda_tau"});
  const contensou::FrictionBall ball{contensou::SmoothPlate{contensou::UniformLaw{}}};
  for (int m = 0; m <= meridians; ++m) {
    for (const auto& d : reproduce::whole_turn(16)) {
      if (d.v < 0) break;  // the half turn from pole to pole
      const auto force = ball.boundary_point(size, {d.v, 0, d.s});
      table.add({static_cast<double>(m), force.x() * std::cos(azimuth(m)), force.x() * std::sin(azimuth(m)),
                 force.z()});
    }
  }
  contensou::write_table(table, folder / "fig04.tsv");
}

void printed_ball(const std::filesystem::path& folder) {
  contensou::Table table = reproduce::curve_table(
      "4", "meridians of the friction ball as printed, LG03 (2.19), upper half, on the reader's side",
      "forces in μλ_N", "LG03 (2.19), both branches to their last printed term",
      {"meridian", "lambda_t1", "lambda_t2", "lambda_tau"});
  const auto border = reproduce::border(contensou::printed_uniform_plate(), 32);
  for (int m = 30; m <= meridians; m += 6) {
    for (const auto& [branch, at] : border) {
      table.add({static_cast<double>(m), at.xi * std::cos(azimuth(m)), at.xi * std::sin(azimuth(m)), at.eta});
    }
  }
  contensou::write_table(table, folder / "fig04_printed.tsv");
}

void write(const std::filesystem::path& folder) {
  exact_ball(folder);
  printed_ball(folder);
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
