// Figure 6: friction force over v for fixed γ_τ and friction torque over γ_τ for fixed v, uniform pressure.
//
// The curve of the fixed value 0 is the limit of the others. It is the graph of a set-valued function: at
// rest the whole interval between the extreme values of the friction ball is admissible, so the graph is
// closed by a vertical segment.

#include <cmath>

#include "../common/curves.hpp"
#include "contensou/law/uniform.hpp"

namespace {

using contensou::Table;

constexpr double range = 2;  // m/s, either side
constexpr int n = 256;       // steps over the whole range

void smooth_curves(const std::filesystem::path& folder) {
  const std::string units = "v and gamma_tau in m/s, forces in μλ_N";
  Table force = reproduce::curve_table("6a", "−λ_T/(μλ_N) over v for fixed γ_τ (m/s, in the column's name)",
                                       units, "UniformLaw", {"v", "0.125", "0.25", "0.5", "1"});
  Table torque = reproduce::curve_table("6b", "−λ_τ/(μλ_N) over γ_τ for fixed v (m/s, in the column's name)",
                                        units, "UniformLaw", {"gamma_tau", "0.125", "0.25", "0.5", "1"});
  const contensou::UniformLaw law;
  for (int k = -n / 2; k <= n / 2; ++k) {
    const double x = range * k / (n / 2);
    std::vector<Table::Cell> forces{x}, torques{x};
    for (const double fixed : {0.125, 0.25, 0.5, 1.0}) {
      forces.emplace_back(reproduce::signed_friction(law, x, fixed).xi);
      torques.emplace_back(reproduce::signed_friction(law, fixed, x).eta);
    }
    force.add(forces);
    torque.add(torques);
  }
  contensou::write_table(force, folder / "fig06a.tsv");
  contensou::write_table(torque, folder / "fig06b.tsv");
}

void set_valued_limits(const std::filesystem::path& folder) {
  const auto [xi, eta] = contensou::UniformLaw{}.extent();  // the set at rest: [−ξ, ξ] and [−η, η]
  Table force = reproduce::curve_table("6a", "the limit γ_τ = 0 (and λ_τ = 0): Coulomb's set-valued friction",
                                       "v in m/s, force in μλ_N", "UniformLaw", {"v", "minus_lambda_t"});
  force.add({-range, -contensou::UniformLaw{}.at(range, 0).xi});
  force.add({0.0, -xi});
  force.add({0.0, xi});
  force.add({range, contensou::UniformLaw{}.at(range, 0).xi});
  contensou::write_table(force, folder / "fig06a_set.tsv");

  Table torque = reproduce::curve_table("6b", "the limit v = 0 (and λ_T = 0): set-valued drilling friction",
                                        "gamma_tau in m/s, force in μλ_N", "UniformLaw",
                                        {"gamma_tau", "minus_lambda_tau"});
  torque.add({-range, -contensou::UniformLaw{}.at(0, range).eta});
  torque.add({0.0, -eta});
  torque.add({0.0, eta});
  torque.add({range, contensou::UniformLaw{}.at(0, range).eta});
  contensou::write_table(torque, folder / "fig06b_set.tsv");
}

void write(const std::filesystem::path& folder) {
  smooth_curves(folder);
  set_valued_limits(folder);
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
