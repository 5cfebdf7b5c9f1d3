#include "animation.hpp"

#include <fmt/format.h>

#include "contensou/output/table.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

// A column as whole numbers in a unit that is small beside what can be seen.
std::string whole(const Table& table, const char* column, double unit) {
  std::string list;
  for (const double x : table.numbers(column)) {
    if (!list.empty()) list += ',';
    list += fmt::format("{:.0f}", x / unit);
  }
  return fmt::format("\"{}\":{{\"unit\":{:g},\"values\":[{}]}}", column, unit, list);
}

// One letter a row: open, slip or stick.
std::string letters(const Table& table, const char* column) {
  std::string list;
  for (const std::string& mode : table.texts(column))
    list += mode == "open" ? 'o' : mode == "slip" ? 's' : 't';
  return fmt::format("\"{}\":\"{}\"", column, list);
}

std::string json(const Table& table) {
  constexpr double lengths = 1e-5, heights = 1e-6, directions = 1e-4, angles = 1e-2, spins = 0.1;
  std::string text = fmt::format("{{\"step\":{:g},", table.numbers("t").at(1));
  for (const auto& [column, unit] : {std::pair{"x_s", lengths},
                                     {"y_s", lengths},
                                     {"z_s", heights},
                                     {"axis_x", directions},
                                     {"axis_y", directions},
                                     {"axis_z", directions},
                                     {"chi", angles},
                                     {"omega_z", spins}}) {
    text += whole(table, column, unit) + ',';
  }
  return text + letters(table, "body") + ',' + letters(table, "tip") + '}';
}

constexpr const char* stage = R"(<figure id="animation" class="stage">
<canvas role="img" aria-label="The tippe-top turning over, standing on its stick and coming back"></canvas>
<div class="controls">
<button type="button" aria-label="Play">▶</button>
<input type="range" min="0" max="1000" value="0" aria-label="Time">
<label>speed <select><option value="0.02">1/50</option><option value="0.1" selected>1/10</option><option value="0.25">1/4</option><option value="1">1</option></select></label>
<output></output>
</div>
<figcaption><p>The motion of Figure 9, Hertz pressure, to scale; squares of 1 cm; traces of the points of contact. Drag to look from elsewhere.</p></figcaption>
<script type="application/json">)";

}  // namespace

std::string animation(const fs::path& report) {
  const fs::path file = report / "data" / "animation.tsv";
  if (!fs::exists(file)) return "<p class=\"missing\">The animation's data are not there yet.</p>\n";
  return stage + json(contensou::read_table(file)) + "</script></figure>\n";
}

}  // namespace report
