// Figure 12: the tippe-top's inclination over time for several contact radii. LG03 shows three and does not name
// them in its text; here they are its R = 5e-4 m, a fifth of it and a twenty-fifth; and R = 1e-3 m, larger than
// it, which does not invert the top faster.

#include <string>
#include <vector>

#include "../common/curves.hpp"
#include "../common/tippe_top_motion.hpp"

namespace {

using contensou::Table;

constexpr double interval = 0.002;  // [s]
const std::vector<std::pair<std::string, double>> radii{
    {"1e-3", 1e-3}, {"5e-4", 5e-4}, {"1e-4", 1e-4}, {"2e-5", 2e-5}};

void write(const std::filesystem::path& folder) {
  Table curve = reproduce::motion_table("12", "inclination for contact radii in m, Hertz pressure", "s, rad", {"t"});
  Table events = reproduce::event_table("12", "events, by contact radius in m");
  std::vector<std::vector<Table::Cell>> rows;
  for (const auto& [name, radius] : radii) {
    curve.columns.push_back(name);
    const contensou::TippeTopAxis top = reproduce::tippe_top(reproduce::Pressure::hertz, radius);
    std::size_t k = 0;
    const auto report = reproduce::move_tippe_top(top, interval, [&](const contensou::Sample& s) {
      if (k == rows.size()) rows.push_back({static_cast<double>(k) * interval});
      rows[k++].push_back(top.inclination(s.q));
    });
    reproduce::add_events(events, name, report);
  }
  for (const auto& row : rows) curve.add(row);
  contensou::write_table(curve, folder / "fig12.tsv");
  contensou::write_table(events, folder / "fig12_events.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
