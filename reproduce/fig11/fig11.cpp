// Figure 11: Magnus's stability diagram in the (h/r, I₃/I₁) plane, 0 < I₃/I₁ < 2: its lines in closed form,
// and a map of the plane that knows only the roots of LG03 (5.31). The paper's top in both positions. What
// the nonlinear top does at points of the plane comes from verify_stability.

#include <cmath>
#include <string>
#include <vector>

#include "../common/curves.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/system/spinning_top_stability.hpp"

namespace {

using contensou::SpinningPosition;
using contensou::Table;

constexpr double widest = 5;   // h/r; the paper's top on its tip is at 4.2
constexpr double highest = 2;  // I₃/I₁ of a body is never larger

void write_borders(const std::filesystem::path& folder) {
  Table borders =
      reproduce::curve_table("11", "borders of Magnus's regions", "dimensionless",
                             "h/r = 1 and h/r = I_1/I_3, LG03 5.5", {"line", "h_over_r", "i3_over_i1"});
  for (const double y : {0.0, highest}) borders.add({std::string("a = 0"), 1.0, y});
  constexpr int pieces = 128;
  for (int k = 0; k <= pieces; ++k) {
    const double y = highest * std::pow(highest * widest, -static_cast<double>(k) / pieces);
    borders.add({std::string("hyperbola"), 1 / y, y});
  }
  contensou::write_table(borders, folder / "fig11.tsv");
}

/// m, I₁, h of the paper's top on its body.
SpinningPosition of_shape(double h_over_r, double i3_over_i1) {
  SpinningPosition p = contensou::trivial_position({});
  const double h = p.h();
  p.i3 = i3_over_i1 * p.i1;
  p.r = h / h_over_r;
  p.a = p.r - h;
  return p;
}

/// The region a position is in as the signs of the largest real part over the spin have it; "none" for a
/// pattern that none of the four has.
std::string region_by_roots(const SpinningPosition& p) {
  const contensou::SlowSlip contact{.mu = 0.3, .radius = 5e-4, .slope = initial_slope(contensou::HertzLaw{})};
  // Two decades on both sides of the spin at which gyroscopic and gravity torque are of one size.
  const double unit = std::sqrt(p.m * p.g * p.h() / p.i1);
  constexpr int steps = 32;
  int changes = 0;
  bool first = false, last = false;
  for (int k = 0; k <= steps; ++k) {
    const double omega = unit * std::pow(10.0, 4.0 * k / steps - 2);
    const bool stable =
        contensou::eigenvalues(characteristic_cubic(p, omega, slip_damping(p, contact, omega)))[0].real() < 0;
    if (k == 0) first = stable;
    if (k > 0 && stable != last) ++changes;
    last = stable;
  }
  if (changes > 1) return "none";
  if (changes == 0) return first ? "III" : "I";
  return first ? "IV" : "II";
}

void write_map(const std::filesystem::path& folder) {
  Table map = reproduce::curve_table("11", "regions from the signs of the largest real part over the spin",
                                     "dimensionless", "the roots of LG03 (5.31), Hertz pressure, R = 5e-4 m",
                                     {"h_over_r", "i3_over_i1", "region"});
  constexpr int columns = 50, rows = 20;
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      // Off the lines: the middles of cells.
      const double x = widest * (i + 0.5) / columns, y = highest * (k + 0.5) / rows;
      map.add({x, y, region_by_roots(of_shape(x, y))});
    }
  }
  contensou::write_table(map, folder / "fig11_roots.tsv");
}

void write_positions(const std::filesystem::path& folder) {
  Table positions = reproduce::curve_table("11", "the top of LG03 5.4", "dimensionless; critical_spin: rad/s",
                                           "magnus_region, "
                                           "critical_spin",
                                           {"position", "h_over_r", "i3_over_i1", "region", "critical_spin"});
  const auto add = [&](const char* name, const SpinningPosition& p) {
    positions.add({std::string(name), p.h() / p.r, p.i3 / p.i1,
                   std::string(contensou::name(magnus_region(p))), contensou::critical_spin(p).value()});
  };
  add("trivial", contensou::trivial_position({}));
  add("inverted", contensou::inverted_position({}));
  contensou::write_table(positions, folder / "fig11_positions.tsv");
}

void write(const std::filesystem::path& folder) {
  write_borders(folder);
  write_map(folder);
  write_positions(folder);
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
