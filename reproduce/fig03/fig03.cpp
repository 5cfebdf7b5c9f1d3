// Figure 3: the admissible forces of a uniform pressure. (a) the friction disk D_T, λ_τ = 0; (b) the friction
// plate P_F; (c), not in the paper, the projection onto it, LG03 (4.12).
//
// Disk and plate are plane cuts of the friction ball. Over the plate the border as LG03 (2.18) prints it,
// whose two branches are truncated series in ξ and in η and do not meet at ξ* = 55/64.

#include <array>
#include <cmath>

#include "../common/curves.hpp"
#include "contensou/ball/friction_ball.hpp"
#include "contensou/ball/plate_series.hpp"
#include "contensou/ball/smooth_plate.hpp"

namespace {

using contensou::Table;

constexpr double size = 1;  // μλ_N, the unit of the forces

const contensou::FrictionBall ball{contensou::SmoothPlate{contensou::UniformLaw{}}};

void friction_disk(const std::filesystem::path& folder) {
  Table disk =
      reproduce::curve_table("3a", "border of the friction disk D_T, LG03 (2.15)", "forces in μλ_N",
                             "UniformLaw, its friction ball without torque", {"lambda_t1", "lambda_t2"});
  for (const auto& d : reproduce::whole_turn(32)) {
    const auto force = ball.boundary_point(size, {d.v, d.s, 0});  // (v, s) taken as a direction of sliding
    disk.add({force.x(), force.y()});
  }
  contensou::write_table(disk, folder / "fig03a.tsv");
}

void friction_plate(const std::filesystem::path& folder) {
  Table plate =
      reproduce::curve_table("3b", "border of the friction plate P_F, exact", "forces in μλ_N",
                             "UniformLaw, its friction ball cut at λ_T2 = 0", {"lambda_t", "lambda_tau"});
  for (const auto& d : reproduce::whole_turn(64)) {
    const auto force = ball.boundary_point(size, {d.v, 0, d.s});
    plate.add({force.x(), force.z()});
  }
  contensou::write_table(plate, folder / "fig03b.tsv");
}

void printed_plate(const std::filesystem::path& folder) {
  Table printed = reproduce::curve_table(
      "3b", "border of the friction plate as printed, LG03 (2.18), one quarter of it", "forces in μλ_N",
      "LG03 (2.18), both branches to their last printed term", {"branch", "lambda_t", "lambda_tau"});
  for (const auto& [branch, at] : reproduce::border(contensou::printed_uniform_plate(), 32)) {
    printed.add({branch, at.xi, at.eta});
  }
  contensou::write_table(printed, folder / "fig03b_printed.tsv");
}

void projections(const std::filesystem::path& folder) {
  Table table =
      reproduce::curve_table("3c", "forces and the nearest points of the friction plate, LG03 (4.12)",
                             "forces in μλ_N", "UniformLaw, its friction ball cut at λ_T2 = 0",
                             {"lambda_t", "lambda_tau", "nearest_t", "nearest_tau", "inside"});
  struct Point {
    double t, tau;
  };
  constexpr std::array<Point, 17> points{{{0, 0.875},
                                          {0.125, 0.8125},
                                          {0.25, 1},
                                          {0.375, 0.75},
                                          {0.5, 0.875},
                                          {0.6875, 0.9375},
                                          {0.75, 0.625},
                                          {1, 0.875},
                                          {0.9375, 0.4375},
                                          {1.125, 0.6875},
                                          {1.25, 0.5},
                                          {1.0625, 0.25},
                                          {1.25, 0.25},
                                          {1.125, 0.0625},
                                          {1.25, 0},
                                          {0.5, 0.25},
                                          {0.25, 0.5}}};
  for (const auto [t, tau] : points) {
    const auto nearest = ball.project({t, 0, tau}, size);
    table.add({t, tau, nearest.point.x(), nearest.point.z(), std::string(nearest.inside ? "1" : "0")});
  }
  contensou::write_table(table, folder / "fig03c.tsv");
}

void write(const std::filesystem::path& folder) {
  friction_disk(folder);
  friction_plate(folder);
  printed_plate(folder);
  projections(folder);
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
