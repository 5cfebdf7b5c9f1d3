// Figure 3: the admissible forces of a uniform pressure. (a)
// the friction disk D_T, λ_τ = 0; (b) the friction plate P_F.
//
// The plate's border is the law itself, (ξ(u), η(u)) for u in [0, ∞]. Over it the border as LG03 (2.18)
// prints it, whose two branches are truncated series in ξ and in η and do not meet at ξ* = 55/64.

#include <cmath>

#include "../common/curves.hpp"
#include "contensou/law/uniform.hpp"

namespace {

using contensou::Table;

void friction_disk(const std::filesystem::path& folder) {
  Table disk = reproduce::curve_table("3a", "border of the friction disk D_T, LG03 (2.15)", "forces in μλ_N",
                                      "UniformLaw, no spin", {"lambda_t1", "lambda_t2"});
  for (const auto& d : reproduce::whole_turn(32)) {
    const double length = std::hypot(d.v, d.s);  // the direction (v, s) taken as a direction of sliding
    const double xi = contensou::UniformLaw{}.at(length, 0).xi;
    disk.add({xi * (d.v / length), xi * (d.s / length)});
  }
  contensou::write_table(disk, folder / "fig03a.tsv");
}

void friction_plate(const std::filesystem::path& folder) {
  Table plate = reproduce::curve_table("3b", "border of the friction plate P_F, exact", "forces in μλ_N",
                                       "UniformLaw", {"lambda_t", "lambda_tau"});
  for (const auto& d : reproduce::whole_turn(64)) {
    const auto [xi, eta] = reproduce::signed_friction(contensou::UniformLaw{}, d.v, d.s);
    plate.add({xi, eta});
  }
  contensou::write_table(plate, folder / "fig03b.tsv");
}

constexpr double xi_star = 55.0 / 64;  // 1 − 1/8 − 1/64, the end of the branches of (2.18)

// η of the first branch of (2.18): (9/4) η² + (3/2) ξ² − (15/32) ξ⁴ − (5/128) ξ⁶ = 1.
double printed_eta_inner(double xi) {
  const double x = xi * xi;
  return 2.0 / 3 * std::sqrt(1 - x * (1.5 - x * (15.0 / 32 + x * (5.0 / 128))));
}

// η of the second branch of (2.18): ξ² + 4 η² − (20/3) η⁴ + (40/9) η⁶ = 1. The cubic in y = η² rises
// everywhere and is concave for y < 1/2, so Newton's method from the left converges monotonically.
double printed_eta_outer(double xi) {
  const double rest = (1 - xi) * (1 + xi);
  double y = rest / 4;
  for (int i = 0; i < 20; ++i) {
    const double value = y * (4 - y * (20.0 / 3 - y * (40.0 / 9))) - rest;
    y -= value / (4 - y * (40.0 / 3 - y * (40.0 / 3)));
  }
  return std::sqrt(y);
}

void printed_plate(const std::filesystem::path& folder) {
  Table printed = reproduce::curve_table(
      "3b", "border of the friction plate as printed, LG03 (2.18), one quarter of it", "forces in μλ_N",
      "LG03 (2.18), both branches to their last printed term", {"branch", "lambda_t", "lambda_tau"});
  constexpr int n = 32;
  for (int k = 0; k <= n; ++k) {
    const double xi = xi_star * (static_cast<double>(k) / n);
    printed.add({"inner", xi, printed_eta_inner(xi)});
  }
  for (int k = n; k >= 0; --k) {
    // Quadratic spacing, as η ~ √(1 − ξ); an exact double.
    const double xi = 1 - (1 - xi_star) * (static_cast<double>(k * k) / (n * n));
    printed.add({"outer", xi, printed_eta_outer(xi)});
  }
  contensou::write_table(printed, folder / "fig03b_printed.tsv");
}

void write(const std::filesystem::path& folder) {
  friction_disk(folder);
  friction_plate(folder);
  printed_plate(folder);
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
