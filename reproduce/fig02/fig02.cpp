// Figure 2: the velocity potential Φ of a uniform pressure as a function of v and ωR.
//
// Φ is homogeneous of degree one (a cone), so the contour line Φ/(μλ_N) = c is exactly c (v, ωR)/Φ(v, ωR) for
// every direction (v, ωR): no contouring algorithm stands between the law and the drawing.

#include "../common/curves.hpp"
#include "contensou/law/uniform.hpp"

namespace {

using contensou::Table;

struct ContourPoint {
  double v;
  double s;
};

ContourPoint contour_point(double level, const reproduce::Direction& d) {
  const double phi = contensou::potential(contensou::UniformLaw{}, std::abs(d.v), std::abs(d.s));
  return {level * (d.v / phi), level * (d.s / phi)};
}

void write(const std::filesystem::path& folder) {
  Table cone = reproduce::curve_table(
      "2a", "the cone of the velocity potential, meshed by contour lines and rays",
      "v and omega_r = ωR in m/s, phi = Φ/(μλ_N) in m/s", "UniformLaw", {"phi", "v", "omega_r"});
  for (int ring = 0; ring <= 8; ++ring) {
    const double level = ring / 8.0;
    for (const auto& d : reproduce::whole_turn(16)) {
      const auto [v, s] = contour_point(level, d);
      cone.add({level, v, s});
    }
  }
  contensou::write_table(cone, folder / "fig02a.tsv");

  Table contours = reproduce::curve_table("2b", "contour lines of the velocity potential",
                                          "v and omega_r = ωR in m/s, phi = Φ/(μλ_N) in m/s", "UniformLaw",
                                          {"phi", "v", "omega_r"});
  for (const double level : {0.25, 0.5, 0.75, 1.0}) {
    for (const auto& d : reproduce::whole_turn(32)) {
      const auto [v, s] = contour_point(level, d);
      contours.add({level, v, s});
    }
  }
  contensou::write_table(contours, folder / "fig02b.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
