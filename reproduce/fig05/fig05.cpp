// Figure 5: friction force over u and friction torque over
// 1/u, for a uniform and for a Hertz ("parabolic") pressure.

#include "../common/curves.hpp"
#include "contensou/law/hertz.hpp"
#include "contensou/law/uniform.hpp"

namespace {

using contensou::Table;

void write(const std::filesystem::path& folder) {
  constexpr double last = 4;
  constexpr int n = 256;
  const contensou::UniformLaw uniform;
  const contensou::HertzLaw hertz;

  Table force =
      reproduce::curve_table("5a", "friction force ξ = ‖λ_T‖/(μλ_N) over u = |v|/(|ω|R)", "dimensionless",
                             "UniformLaw, HertzLaw", {"u", "xi_uniform", "xi_hertz"});
  Table torque =
      reproduce::curve_table("5b", "friction torque η = |λ_τ|/(μλ_N) over 1/u = |ω|R/|v|", "dimensionless",
                             "UniformLaw, HertzLaw", {"inverse_u", "eta_uniform", "eta_hertz"});
  for (int k = 0; k <= n; ++k) {
    const double x = last * k / n;
    force.add({x, uniform.at(x, 1).xi, hertz.at(x, 1).xi});
    torque.add({x, uniform.at(1, x).eta, hertz.at(1, x).eta});
  }
  contensou::write_table(force, folder / "fig05a.tsv");
  contensou::write_table(torque, folder / "fig05b.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
