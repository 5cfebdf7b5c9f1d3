// Figure 4: the friction ball B_F of a uniform pressure: the friction plate turned about the λ_τ axis.

#include <cmath>
#include <numbers>

#include "../common/curves.hpp"
#include "contensou/law/uniform.hpp"

namespace {

void write(const std::filesystem::path& folder) {
  contensou::Table ball = reproduce::curve_table(
      "4", "the friction ball B_F, meshed by meridians and parallels", "forces in μλ_N", "UniformLaw",
      {"meridian", "lambda_t1", "lambda_t2", "lambda_tau"});
  constexpr int meridians = 48;
  for (int m = 0; m <= meridians; ++m) {
    const double azimuth = 2 * std::numbers::pi * m / meridians;
    for (const auto& d : reproduce::whole_turn(16)) {
      if (d.v < 0) break;  // the half turn from pole to pole
      const auto [xi, eta] = reproduce::signed_friction(contensou::UniformLaw{}, d.v, d.s);
      ball.add({static_cast<double>(m), xi * std::cos(azimuth), xi * std::sin(azimuth), eta});
    }
  }
  contensou::write_table(ball, folder / "fig04.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
