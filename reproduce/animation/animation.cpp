// The motion of Figure 9 (Hertz pressure) as an animation needs it: place and axis of the tippe-top, and how
// far it has turned about its axis. report/top.js draws it.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "../common/curves.hpp"
#include "../common/tippe_top_motion.hpp"

namespace {

using contensou::Table;
using Eigen::Vector3d;

// Between samples the attitude is turned about the mean of their ω: at 180 rad/s a fiftieth of a radian.
constexpr double interval = 1e-4;  // [s]
constexpr int shown = 40;          // every so many are kept: 4 ms, a tenth of a nutation

/// Of a direction fixed in the top from the line of nodes e_3^1 × e, about the axis e; in (−π, π].
double turned(const Vector3d& direction, const Vector3d& axis) {
  const Vector3d nodes = Vector3d::UnitZ().cross(axis).normalized();
  return std::atan2(direction.dot(axis.cross(nodes)), direction.dot(nodes));
}

std::string word(contensou::ContactMode mode) {
  return mode == contensou::ContactMode::open   ? "open"
         : mode == contensou::ContactMode::slip ? "slip"
                                                : "stick";
}

void write(const std::filesystem::path& folder) {
  const contensou::TippeTopAxis top = reproduce::tippe_top(reproduce::Pressure::hertz);
  Table motion = reproduce::curve_table(
      "9",
      "the motion for the animation, Hertz pressure, R = 5e-4 m; chi: about the axis, from the line of nodes",
      "s, m, rad, rad/s", "exact",
      {"t", "x_s", "y_s", "z_s", "axis_x", "axis_y", "axis_z", "chi", "omega_z", "body", "tip"});
  motion.comments.back() = "command: cmake --build build --target animation";
  int k = 0;
  double chi = 0;
  Vector3d mark, omega;
  const auto report = reproduce::move_tippe_top(top, interval, [&](const contensou::Sample& s) {
    const Vector3d axis = top.axis(s.q), now = top.spin(s.q, s.u);
    if (k == 0) {
      mark = Vector3d::UnitZ().cross(axis).normalized();
    } else {
      const Vector3d mean = (omega + now) / 2;
      mark = Eigen::AngleAxisd(mean.norm() * interval, mean.normalized()) * mark;
      mark = (mark - mark.dot(axis) * axis).normalized();
    }
    omega = now;
    chi += std::remainder(turned(mark, axis) - chi, 2 * std::numbers::pi);
    if (k % shown == 0) {
      motion.add({k * interval, s.q[0], s.q[1], s.q[2], axis[0], axis[1], axis[2], chi, now[2],
                  word(s.modes[0]), word(s.modes[1])});
    }
    ++k;
  });
  if (motion.rows.empty()) throw std::logic_error(report.message);
  contensou::write_table(motion, folder / "animation.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
