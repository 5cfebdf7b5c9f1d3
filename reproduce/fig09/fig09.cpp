// Figure 9: the tippe-top's inclination over time, for both pressures, and its nutation from near.

#include <string>
#include <vector>

#include "../common/curves.hpp"
#include "../common/tippe_top_motion.hpp"

namespace {

using contensou::Table;
using reproduce::Pressure;

constexpr double interval = 0.002;        // [s]; a nutation takes 0.04 s and longer
constexpr double near_interval = 0.0005;  // [s]
constexpr double near_from = 0.6, near_to = 1.0;

std::vector<double> inclinations(Pressure pressure, double step, const std::string& run, Table* events) {
  std::vector<double> theta;
  const contensou::TippeTopAxis top = reproduce::tippe_top(pressure);
  const auto report = reproduce::move_tippe_top(
      top, step, [&](const contensou::Sample& s) { theta.push_back(top.inclination(s.q)); });
  if (events != nullptr) reproduce::add_events(*events, run, report);
  return theta;
}

void write(const std::filesystem::path& folder) {
  Table events = reproduce::event_table("9", "events of both motions");
  Table curve = reproduce::motion_table("9", "inclination, R = 5e-4 m", "s, rad", {"t", "hertz", "uniform"});
  const auto hertz = inclinations(Pressure::hertz, interval, "hertz", &events);
  const auto uniform = inclinations(Pressure::uniform, interval, "uniform", &events);
  for (std::size_t k = 0; k < hertz.size(); ++k)
    curve.add({static_cast<double>(k) * interval, hertz[k], uniform[k]});
  contensou::write_table(curve, folder / "fig09.tsv");
  contensou::write_table(events, folder / "fig09_events.tsv");

  Table near = reproduce::motion_table("9", "inclination, from near", "s, rad", {"t", "hertz", "uniform"});
  const auto hertz_near = inclinations(Pressure::hertz, near_interval, "", nullptr);
  const auto uniform_near = inclinations(Pressure::uniform, near_interval, "", nullptr);
  for (std::size_t k = 0; k < hertz_near.size(); ++k) {
    const double t = static_cast<double>(k) * near_interval;
    if (t >= near_from && t <= near_to) near.add({t, hertz_near[k], uniform_near[k]});
  }
  contensou::write_table(near, folder / "fig09_nutation.tsv");

  // The times LG03 5.4 tells.
  Table printed = reproduce::curve_table("9", "times told in LG03 5.4", "s", "as printed", {"t", "what"});
  printed.add({1.5, std::string("stick touches")});
  printed.add({1.6, std::string("upright, from")});
  printed.add({4.0, std::string("upright, to")});
  printed.add({4.55, std::string("body touches")});
  printed.add({4.65, std::string("both touch, from")});
  printed.add({5.4, std::string("both touch, to")});
  contensou::write_table(printed, folder / "fig09_printed.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
