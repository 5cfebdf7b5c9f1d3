// Figure 1: the geometry of the contact surface, drawn for u = R*/R = 0.62.
//
// The surface element dA has polar coordinates (ρ, φ) about the centre and (r, θ)
// about the pole R* e2, the point that is at rest: LG03 (3.1). Its sliding
// velocity w is perpendicular to the line from the pole, ‖w‖ = |ω| r: LG03 (3.5).

#include <cmath>
#include <numbers>

#include "../common/curves.hpp"
#include "../common/outline.hpp"

namespace {

using contensou::Table;
using Eigen::Vector2d;
using reproduce::add_arc;
using reproduce::add_vertex;
using std::numbers::pi;

constexpr double pole = 0.62;          // R*/R = v/(ωR)
constexpr double rho = 0.78;           // ρ/R of dA
constexpr double phi = 19 * pi / 180;  // φ of dA
const Vector2d origin{0, 0};
constexpr double spin_radius = 0.15, spin_end = 0.40 * pi;  // the arrow of ω

// dA: a cell of the (ρ, φ) grid around the point.
void surface_element(Table& curves) {
  constexpr double half_width = 0.04;
  constexpr double half_angle = half_width / rho;
  add_arc(curves, "element", origin, rho + half_width, phi - half_angle, phi + half_angle, 8);
  add_arc(curves, "element", origin, rho - half_width, phi + half_angle, phi - half_angle, 8);
  const double a = phi - half_angle;
  add_vertex(curves, "element", (rho + half_width) * Vector2d(std::cos(a), std::sin(a)));
}

void write(const std::filesystem::path& folder) {
  const double x = rho * std::cos(phi), y = rho * std::sin(phi);
  // LG03 (3.1): r sin θ = ρ cos φ, r cos θ = R* − ρ sin φ; θ counts from −e2 at the pole.
  const double r = std::hypot(x, pole - y), theta = std::atan2(x, pole - y);

  Table curves =
      reproduce::outline_table("1", "geometry of the contact surface", "lengths in R", "LG03 (3.1)");
  add_arc(curves, "disc", origin, 1, 0, 2 * pi);
  add_arc(curves, "phi", origin, 0.30, 0, phi);
  add_arc(curves, "theta", {0, pole}, 0.2, -pi / 2, -pi / 2 + theta);
  add_arc(curves, "omega", origin, spin_radius, spin_end - 1.3 * pi, spin_end);
  surface_element(curves);
  contensou::write_table(curves, folder / "fig01_curves.tsv");

  Table lines = reproduce::line_table("1", "geometry of the contact surface",
                                      "lengths in R; velocities in |ω|R", "LG03 (2.3), (3.1), (3.5)");
  lines.add({"e1", 0.0, 0.0, 1.28, 0.0});
  lines.add({"e2", 0.0, 0.0, 0.0, 1.28});
  lines.add({"rho", 0.0, 0.0, x, y});
  lines.add({"r", 0.0, pole, x, y - pole});
  const double radius_angle = 215 * pi / 180;
  lines.add({"R", 0.0, 0.0, std::cos(radius_angle), std::sin(radius_angle)});
  lines.add({"v", 0.0, 0.0, pole, 0.0});
  // The head of the arrow that turns about e3: along the tangent at the end of the arc "omega".
  const double head = 0.06;
  lines.add({"omega", spin_radius * std::cos(spin_end) + head * std::sin(spin_end),
             spin_radius * std::sin(spin_end) - head * std::cos(spin_end), -head * std::sin(spin_end),
             head * std::cos(spin_end)});
  lines.add({"w", x, y, pole - y, x});  // ω e3 × (dA − pole) in units of ωR
  contensou::write_table(lines, folder / "fig01_lines.tsv");

  Table points = reproduce::curve_table("1", "the surface element dA in both coordinate systems and the pole",
                                        "lengths in R, angles in rad", "none; LG03 (2.3), (3.1)",
                                        {"x", "y", "rho", "phi", "r", "theta", "pole"});
  points.add({x, y, rho, phi, r, theta, pole});
  contensou::write_table(points, folder / "fig01.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
