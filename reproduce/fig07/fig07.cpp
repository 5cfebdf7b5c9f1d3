// Figure 7: the tippe-top of LG03 5.4, to scale. (a) its geometry, inclined and lifted off the floor, seen
// along the line of nodes e_1^2; (b) the two stationary positions of LG03 5.5.
//
// What of the outline touches the floor is data: the spheres about M and N. The rest is drawn so that it
// stays clear of the floor in every position: the body's sphere ends just beyond the last point of it that
// can touch, where the floor touches both spheres; the stick is a cylinder.

#include <cmath>
#include <numbers>
#include <string>

#include "../common/curves.hpp"
#include "../common/outline.hpp"
#include "contensou/system/tippe_top_model.hpp"

namespace {

using contensou::Table;
using contensou::TippeTopData;
using Eigen::Vector2d;
using reproduce::add_arc;
using reproduce::add_line;
using reproduce::add_place;
using reproduce::add_vertex;
using std::numbers::pi;

constexpr double degree = pi / 180;
constexpr double mm = 1e3;  // the drawing's unit is a millimetre
const Vector2d up{0, 1}, right{1, 0};

// The top at an inclination in the plane (e_2^2, e_3^1) of the drawing; e_1^2 points at the reader.
struct Pose {
  TippeTopData top;  // lengths in mm
  double theta;
  Vector2d s;  // centre of mass

  Vector2d axis() const { return {-std::sin(theta), std::cos(theta)}; }
  Vector2d across() const { return {std::cos(theta), std::sin(theta)}; }
  Vector2d at(double along, double aside = 0) const { return s + along * axis() + aside * across(); }
  Vector2d m() const { return at(top.a1); }
  Vector2d n() const { return at(top.a2); }
  double axis_angle() const { return pi / 2 + theta; }
};

TippeTopData in_millimetres() {
  TippeTopData top;
  for (double* length : {&top.a1, &top.a2, &top.r1, &top.r2}) *length *= mm;
  return top;
}

// Angle about M from the axis to where the body's sphere ends.
double rim(const TippeTopData& top) {
  const double last_contact = std::acos((top.r1 - top.r2) / (top.a2 - top.a1));
  return last_contact - 3 * degree;
}

void outlines(Table& curves, const Pose& pose) {
  const TippeTopData& top = pose.top;
  const double axis = pose.axis_angle(), end = rim(top);
  add_arc(curves, "body", pose.m(), top.r1, axis + end, axis + 2 * pi - end);
  add_vertex(curves, "body", pose.m() + top.r1 * Vector2d(std::cos(axis + end), std::sin(axis + end)));
  add_vertex(curves, "stick", pose.at(top.a1 + top.r1 * std::cos(end), top.r2));
  add_arc(curves, "stick", pose.n(), top.r2, axis - pi / 2, axis + pi / 2);
  add_vertex(curves, "stick", pose.at(top.a1 + top.r1 * std::cos(end), -top.r2));
  add_arc(curves, "construction_body", pose.m(), top.r1, axis - end, axis + end);
  add_arc(curves, "construction_tip", pose.n(), top.r2, axis + pi / 2, axis + 1.5 * pi);
}

void write_geometry(const std::filesystem::path& folder) {
  const double lift = 4.5;
  Pose pose{in_millimetres(), 38 * degree, {}};
  const TippeTopData& top = pose.top;
  pose.s = {0, lift + top.r1 - top.a1 * std::cos(pose.theta)};  // LG03 (5.13) with g_N1 = lift
  const Vector2d m = pose.m(), n = pose.n(), s = pose.s;
  const Vector2d c = m - top.r1 * up, lowest_of_tip = n - top.r2 * up;
  const auto on_floor = [](const Vector2d& p) { return Vector2d(p.x(), 0); };

  const char* const what = "geometry of the tippe-top";
  const char* const units = "lengths in mm";
  const char* const source = "TippeTopData, LG03 5.4, (5.10)-(5.14)";
  Table curves = reproduce::outline_table("7a", what, units, source);
  outlines(curves, pose);
  const double theta_radius = top.a2 + top.r2 + 2.2;
  add_arc(curves, "theta", s, theta_radius, pi / 2, pose.axis_angle());
  contensou::write_table(curves, folder / "fig07a_curves.tsv");

  Table lines = reproduce::line_table("7a", what, units, source);
  add_line(lines, "axis", pose.at(top.a1 - top.r1 - 3), pose.at(top.a2 + top.r2));
  add_line(lines, "e3_4", pose.at(top.a2 + top.r2), pose.at(top.a2 + top.r2 + 6));
  add_line(lines, "vertical", s, s + theta_radius * up);
  add_line(lines, "r1", m, m + top.r1 * Vector2d(std::cos(-25 * degree), std::sin(-25 * degree)));
  const double tip_angle = pose.axis_angle() + 35 * degree;
  add_line(lines, "r2", n, n + top.r2 * Vector2d(std::cos(tip_angle), std::sin(tip_angle)));
  // Distances along the axis: a2 on the right of it, a1 on the left.
  const double aside = 4.2;
  for (const auto& [name, length, side] : {std::tuple{"a2", top.a2, aside}, {"a1", top.a1, -aside}}) {
    add_line(lines, name, pose.at(0, side), pose.at(length, side));
    add_line(lines, "extension", pose.at(0), pose.at(0, side * 1.25));
    add_line(lines, "extension", pose.at(length), pose.at(length, side * 1.25));
  }
  add_line(lines, "extension", m, c);
  add_line(lines, "g_n1", on_floor(c), c);
  const Vector2d height_of_s{20.5, s.y()}, height_of_tip{-21.5, lowest_of_tip.y()};
  add_line(lines, "extension", s, height_of_s + right);
  add_line(lines, "z_s", on_floor(height_of_s), height_of_s);
  add_line(lines, "extension", lowest_of_tip, height_of_tip - right);
  add_line(lines, "g_n2", on_floor(height_of_tip), height_of_tip);
  const Vector2d origin{27, 0};
  add_line(lines, "e2_1", origin, origin + 7 * right);
  add_line(lines, "e3_1", origin, origin + 7 * up);
  add_line(lines, "floor", {-27, 0}, {35, 0});
  contensou::write_table(lines, folder / "fig07a_lines.tsv");

  Table places = reproduce::place_table("7a", what, units, source);
  add_place(places, "S", s);
  add_place(places, "M", m);
  add_place(places, "N", n);
  add_place(places, "C", c);
  add_place(places, "M_floor", on_floor(m));
  add_place(places, "T", lowest_of_tip);
  add_place(places, "O", origin);
  add_place(places, "theta",
            s + theta_radius * Vector2d(-std::sin(pose.theta / 2), std::cos(pose.theta / 2)));
  contensou::write_table(places, folder / "fig07a.tsv");
}

void write_positions(const std::filesystem::path& folder) {
  const TippeTopData top = in_millimetres();
  const Pose trivial{top, 0, {0, top.r1 - top.a1}};
  const Pose inverted{top, pi, {42, top.r2 + top.a2}};

  const char* const what = "the trivial and the inverted position";
  const char* const units = "lengths in mm";
  const char* const source = "TippeTopData, LG03 5.5, h = r − a";
  Table curves = reproduce::outline_table("7b", what, units, source);
  Table lines = reproduce::line_table("7b", what, units, source);
  Table places = reproduce::place_table("7b", what, units, source);
  for (const auto& [name, pose] :
       {std::pair<std::string, Pose>{"trivial", trivial}, {"inverted", inverted}}) {
    outlines(curves, pose);
    add_line(lines, "axis", {pose.s.x(), -3}, {pose.s.x(), 34});
    const Vector2d foot{pose.s.x() - 18, 0};
    add_line(lines, "extension", pose.s, {foot.x() - 1, pose.s.y()});
    add_line(lines, "h", foot, {foot.x(), pose.s.y()});
    add_place(places, "S", pose.s);
    add_place(places, "M", pose.m());
    add_place(places, "N", pose.n());
    add_place(places, ("h " + name).c_str(), {foot.x(), pose.s.y() / 2});
    add_place(places, name.c_str(), {pose.s.x(), 0});
  }
  add_line(lines, "floor", {-25, 0}, {64, 0});
  contensou::write_table(curves, folder / "fig07b_curves.tsv");
  contensou::write_table(lines, folder / "fig07b_lines.tsv");
  contensou::write_table(places, folder / "fig07b.tsv");
}

void write(const std::filesystem::path& folder) {
  write_geometry(folder);
  write_positions(folder);
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
