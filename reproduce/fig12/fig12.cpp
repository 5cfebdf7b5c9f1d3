// Figure 12: the tippe-top's inclination over time for several contact radii. LG03 shows three and does not
// name them in its text; here they are its R = 5e-4 m, a fifth of it and a twenty-fifth; and R = 1e-3 m,
// larger than it, which does not invert the top faster.

#include <string>
#include <utility>
#include <vector>

#include "../common/curves.hpp"
#include "../common/tippe_top_motion.hpp"

namespace {

using contensou::Table;

constexpr double interval = 0.002;  // [s]
const std::vector<std::pair<std::string, double>> radii{
    {"1e-3", 1e-3}, {"5e-4", 5e-4}, {"1e-4", 1e-4}, {"2e-5", 2e-5}};

void write(const std::filesystem::path& folder) {
  Table curve =
      reproduce::motion_table("12", "inclination for contact radii in m, Hertz pressure", "s, rad", {"t"});
  Table events = reproduce::event_table("12", "events, by contact radius in m");
  std::vector<std::vector<double>> curves;
  for (const auto& [name, radius] : radii) {
    curve.columns.push_back(name);
    std::vector<double>& theta = curves.emplace_back();
    const contensou::TippeTopAxis top = reproduce::tippe_top(reproduce::Pressure::hertz, radius);
    const auto report = reproduce::move_tippe_top(
        top, interval, [&](const contensou::Sample& s) { theta.push_back(top.inclination(s.q)); });
    reproduce::add_events(events, name, report);
  }
  for (std::size_t k = 0; k < curves.front().size(); ++k) {
    std::vector<Table::Cell> row(1 + curves.size());
    row[0] = static_cast<double>(k) * interval;
    for (std::size_t i = 0; i < curves.size(); ++i) row[1 + i] = curves[i][k];
    curve.add(row);
  }
  contensou::write_table(curve, folder / "fig12.tsv");
  contensou::write_table(events, folder / "fig12_events.tsv");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::figure_main(argc, argv, write); }
