// Beside the phase map of inversion, which contensou sweep computes: at which spin the top could at best lie
// on its side, and touch the floor with its stick.
//
// Where friction only slides, at the lowest point C of the body, Jellet's integral J = −L·SC is conserved:
// the torque about S is SC × λ. Of all motions with one J and one inclination the one that has the least
// energy turns about SC, at rest in C and S, and has
//     V(θ) = mg(r1 − a1 cos θ) + J²/(2 D(θ)),   D = I1 r1² sin²θ + I3 (r1 cos θ − a1)²
// Sliding takes energy until it is least. V' = 0 means
//     J² = m g a1 D²/(r1 ((I1 − I3) r1 cos θ + I3 a1))
// which grows with θ as long as the bracket is positive and I1 > I3: to each J one inclination. The drilling
// torque takes J as well, so these are the least spins at any radius.

#include <cmath>
#include <stdexcept>
#include <string>

#include "../common/curves.hpp"
#include "contensou/system/tippe_top_model.hpp"

namespace {

using contensou::Table;
using contensou::TippeTopData;

/// The spin about the axis [rad/s] from which, starting at inclination `from`, sliding alone leads to the
/// inclination with this cosine.
double least_spin(const TippeTopData& top, double from, double cosine) {
  const double along = top.r1 * cosine - top.a1;
  const double d = top.i1 * top.r1 * top.r1 * (1 - cosine * cosine) + top.i3 * along * along;
  const double bracket = (top.i1 - top.i3) * top.r1 * cosine + top.i3 * top.a1;
  if (!(bracket > 0 && top.i1 > top.i3)) throw std::domain_error("no inclination of least energy");
  const double jellet = d * std::sqrt(top.m * top.g * top.a1 / (top.r1 * bracket));
  return jellet / (top.i3 * (top.r1 * std::cos(from) - top.a1));
}

void write(const std::filesystem::path& folder) {
  const TippeTopData top;
  constexpr double from = 0.1;  // scenes/tippe_top.toml
  const double both_touch = (top.r1 - top.r2) / (top.a1 - top.a2);
  Table table;
  table.comments = {
      "least spins at which the top of LG03 5.4 could lie on its side, and touch with its stick",
      "units: rad, rad/s", "by: Jellet's integral, least energy, no drilling torque"};
  table.columns = {"what", "theta", "psi_dot"};
  table.add({std::string("side"), std::acos(0.0), least_spin(top, from, 0)});
  table.add({std::string("stick"), std::acos(both_touch), least_spin(top, from, both_touch)});
  contensou::write_table(table, folder / "phase_map_spins.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
