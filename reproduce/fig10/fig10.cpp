// Figure 10: the distances of both contacts from the floor, and how the rocking between them accumulates.

#include <string>

#include "../common/curves.hpp"
#include "../common/tippe_top_motion.hpp"

namespace {

using contensou::EventKind;
using contensou::Table;

constexpr double interval = 0.002;        // [s]
constexpr double near_interval = 0.0001;  // [s]
constexpr double near_from = 4.74, near_to = 4.91;

void write(const std::filesystem::path& folder) {
  const contensou::TippeTopAxis top = reproduce::tippe_top(reproduce::Pressure::hertz);
  contensou::RunReport report;
  const auto gaps = [&](const char* what, double step, double from, double to) {
    Table table = reproduce::motion_table("10", what, "s, m", {"t", "body", "tip"});
    int k = 0;
    report = reproduce::move_tippe_top(top, step, [&](const contensou::Sample& s) {
      const double t = k++ * step;
      if (t >= from && t <= to) table.add({t, top.gap(0, s.t, s.q), top.gap(1, s.t, s.q)});
    });
    return table;
  };
  contensou::write_table(
      gaps("distances of the contacts, Hertz pressure, R = 5e-4 m", interval, 0, reproduce::motion_end),
      folder / "fig10.tsv");
  contensou::write_table(gaps("distances while the top rocks", near_interval, near_from, near_to),
                         folder / "fig10_rocking.tsv");

  // Between an impact and the next one the other contact is open: how long, and how long before the end.
  double end = 0;
  for (const auto& e : report.events) {
    if (e.kind == EventKind::accumulation) end = e.t;
  }
  Table impacts = reproduce::motion_table("10", "impacts of the rocking until they accumulate", "s",
                                          {"impact", "contact", "t", "until_next", "until_end"});
  const contensou::Event* previous = nullptr;
  int count = 0;
  for (const auto& e : report.events) {
    if (e.kind != EventKind::close || e.t < near_from || e.t > end) continue;
    if (previous != nullptr) {
      impacts.add({static_cast<double>(++count), std::string(previous->contact == 0 ? "body" : "tip"),
                   previous->t, e.t - previous->t, end - previous->t});
    }
    previous = &e;
  }
  contensou::write_table(impacts, folder / "fig10_impacts.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
