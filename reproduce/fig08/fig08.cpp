// Figure 8: the Euler angles of the tippe-top, LG03 (5.1), seen in parallel projection.
//
// e^1 turned by φ about e_3^1 is e^2, by θ about e_1^2 is e^3, by ψ about e_3^3 is e^4. The two discs are the
// planes e_3^1 and e_3^4 stand on; they meet in the line of nodes e_1^2 = e_1^3.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "../common/curves.hpp"
#include "../common/outline.hpp"

namespace {

using contensou::Table;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using reproduce::add_line;
using reproduce::add_place;
using reproduce::add_vertex;
using std::numbers::pi;

constexpr double degree = pi / 180;
constexpr double phi = 42 * degree, theta = 38 * degree, psi = 46 * degree;
constexpr double azimuth = 28 * degree, elevation = 22 * degree;  // of the reader, from e_1^1

// The rows of A^21, A^31, A^41 are the base vectors of e^2, e^3, e^4 in e^1: LG03 (5.1).
Matrix3d a43() { return Eigen::AngleAxisd(-psi, Vector3d::UnitZ()).toRotationMatrix(); }
Matrix3d a32() { return Eigen::AngleAxisd(-theta, Vector3d::UnitX()).toRotationMatrix(); }
Matrix3d a21() { return Eigen::AngleAxisd(-phi, Vector3d::UnitZ()).toRotationMatrix(); }

const Vector3d to_reader{std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation)};

Vector2d seen(const Vector3d& p) {
  const Vector3d right{-std::sin(azimuth), std::cos(azimuth), 0};
  return {p.dot(right), p.dot(to_reader.cross(right))};
}

// The part of the circle through two unit vectors a and b ⊥ a from angle `from` to `to`, a being at 0.
void circle(Table& curves, const char* name, const Vector3d& a, const Vector3d& b, double radius, double from,
            double to) {
  constexpr int pieces = 96;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = from + (to - from) * k / pieces;
    add_vertex(curves, name, seen(radius * (std::cos(angle) * a + std::sin(angle) * b)));
  }
}

void write(const std::filesystem::path& folder) {
  const Matrix3d e1 = Matrix3d::Identity(), e2 = a21(), e3 = a32() * e2, e4 = a43() * e3;
  const auto row = [](const Matrix3d& frame, int i) { return Vector3d(frame.row(i)); };

  const char* const what = "the Euler angles of the tippe-top";
  const char* const units = "dimensionless";
  const char* const source = "LG03 (5.1)";
  Table curves = reproduce::outline_table("8", what, units, source);
  // The level disc; the half of the tilted one below it, and the half above.
  circle(curves, "level", row(e1, 0), row(e1, 1), 1, 0, 2 * pi);
  circle(curves, "tilted_below", row(e3, 0), row(e3, 1), 1, pi, 2 * pi);
  circle(curves, "tilted_above", row(e3, 0), row(e3, 1), 1, 0, pi);
  circle(curves, "phi", row(e1, 0), row(e1, 1), 0.62, 0, phi);
  circle(curves, "theta", row(e2, 2), -row(e2, 1), 0.72, 0, theta);
  circle(curves, "psi", row(e3, 0), row(e3, 1), 0.55, 0, psi);
  contensou::write_table(curves, folder / "fig08_curves.tsv");

  Table lines = reproduce::line_table("8", what, units, source);
  Table places = reproduce::place_table("8", what, units, source);
  const auto arrow = [&](const char* name, const Vector3d& direction, double length) {
    add_line(lines, name, {0, 0}, seen(length * direction));
    add_place(places, name, seen((length + 0.09) * direction));
  };
  const double beyond = 1.28;
  arrow("e1_1", row(e1, 0), beyond);
  arrow("e2_1", row(e1, 1), beyond);
  arrow("e3_1", row(e1, 2), beyond);
  arrow("e1_2", row(e2, 0), beyond);
  arrow("e2_2", row(e2, 1), beyond);
  arrow("e2_3", row(e3, 1), beyond);
  arrow("e1_4", row(e4, 0), beyond);
  arrow("e2_4", row(e4, 1), beyond);
  arrow("e3_4", row(e4, 2), beyond);
  add_line(lines, "nodes", seen(-1.15 * row(e2, 0)), {0, 0});
  contensou::write_table(lines, folder / "fig08_lines.tsv");

  const auto label = [&](const char* name, const Vector3d& a, const Vector3d& b, double radius,
                         double angle) {
    add_place(places, name, seen(radius * (std::cos(angle) * a + std::sin(angle) * b)));
  };
  label("phi", row(e1, 0), row(e1, 1), 0.5, phi / 2);
  label("theta", row(e2, 2), -row(e2, 1), 0.8, theta / 2);
  label("psi", row(e3, 0), row(e3, 1), 0.43, psi / 2);
  contensou::write_table(places, folder / "fig08.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
