#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "contensou/ball/plate_series.hpp"
#include "contensou/law/friction_law.hpp"
#include "contensou/output/table.hpp"

/// What the figure programs share: how they are called, how their tables begin, where curves are sampled.
namespace reproduce {

/// A slip direction (v, s), s = ωR, on |v| + |s| = 1.
///
/// The curves of a set (plate, ball, contour lines) are sampled at v = k/N, |s| = 1 − |k|/N with N a power of
/// two: these are exact doubles and so is 1 − v, hence the stored reference curves are for the same arguments
/// to the last bit. u = |v|/|s| = tan ψ then runs over [0, ∞] and the normal angle ψ is sampled evenly to
/// within a factor of two.
struct Direction {
  double v;
  double s;
};

/// The quarter v, s >= 0 from (0, 1), pure spin, to (1, 0), pure sliding: n + 1 directions, n a power of two.
std::vector<Direction> quarter_turn(int n);

/// The whole turn, closed: 4n + 1 directions from (0, 1) over (1, 0), (0, −1), (−1, 0) back to (0, 1).
std::vector<Direction> whole_turn(int n);

/// −λ_T/(μλ_N) and −λ_τ/(μλ_N) with the signs of v and s.
template <contensou::FrictionLaw L>
contensou::Friction signed_friction(const L& law, double v, double s) {
  const auto [xi, eta] = law.at(std::abs(v), std::abs(s));
  return {std::copysign(xi, v), std::copysign(eta, s)};
}

/// A point (ξ, η) of the border of a plate made of two series, and which of the two it is on.
struct PlatePoint {
  std::string branch;  ///< "inner" | "outer"
  contensou::Friction at;
};

/// The quarter of the border from the pole to the equator in 2n + 2 points, both ends of the step at the seam
/// among them, n a power of two. The ξ are exact doubles where the seam is a short binary fraction.
std::vector<PlatePoint> border(const contensou::PlateSeries& plate, int n);

/// An empty table whose comments say what it holds, in which units, by which law, and how to make it again.
contensou::Table curve_table(const std::string& figure, const std::string& what, const std::string& units,
                             const std::string& law, std::vector<std::string> columns);

/// `main` of a figure program: program_main (program.hpp) with write(FOLDER).
int figure_main(int argc, char** argv, void (*write)(const std::filesystem::path& folder));

}  // namespace reproduce
