#include "curves.hpp"

#include <utility>

#include "program.hpp"

namespace reproduce {

std::vector<Direction> quarter_turn(int n) {
  std::vector<Direction> directions;
  for (int k = 0; k <= n; ++k) {
    const double v = static_cast<double>(k) / n;
    directions.push_back({v, 1 - v});
  }
  return directions;
}

std::vector<Direction> whole_turn(int n) {
  std::vector<Direction> directions;
  // Each quarter is the first one turned by 90°: (v, s) -> (s, −v).
  Direction (*const turned[])(Direction) = {[](Direction d) { return d; },
                                            [](Direction d) {
                                              return Direction{d.s, -d.v};
                                            },
                                            [](Direction d) {
                                              return Direction{-d.v, -d.s};
                                            },
                                            [](Direction d) {
                                              return Direction{-d.s, d.v};
                                            }};
  for (const auto turn : turned) {
    for (const Direction& d : quarter_turn(n)) {
      if (d.v < 1) directions.push_back(turn(d));  // (1, 0) begins the next quarter
    }
  }
  directions.push_back({0, 1});
  return directions;
}

std::vector<PlatePoint> border(const contensou::PlateSeries& plate, int n) {
  std::vector<PlatePoint> points;
  for (int k = 0; k <= n; ++k) {
    const double xi = plate.seam * (static_cast<double>(k) / n);
    points.push_back({"inner", {xi, inner_boundary_eta(plate, xi)}});
  }
  for (int k = n; k >= 0; --k) {
    // Quadratic spacing, as η ~ √(1 − ξ).
    const double xi = 1 - (1 - plate.seam) * (static_cast<double>(k * k) / (n * n));
    points.push_back({"outer", {xi, outer_boundary_eta(plate, xi)}});
  }
  return points;
}

contensou::Table curve_table(const std::string& figure, const std::string& what, const std::string& units,
                             const std::string& law, std::vector<std::string> columns) {
  const std::string number = figure.substr(0, figure.find_first_not_of("0123456789"));
  const std::string target = number.size() < 2 ? "fig0" + number : "fig" + number;
  return {{"Figure " + number + ": " + what, "units: " + units, "law: " + law,
           "command: cmake --build build --target " + target},
          std::move(columns),
          {}};
}

int figure_main(int argc, char** argv, void (*write)(const std::filesystem::path& folder)) {
  return program_main(argc, argv, [write](const std::filesystem::path& folder) {
    write(folder);
    return 0;
  });
}

}  // namespace reproduce
