#include "geometry.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "contensou/output/table.hpp"

namespace {

namespace fs = std::filesystem;
using contensou::Table;
using Point = std::complex<double>;

// A handful of operations and library functions on numbers up to `size`.
bool close(const char* what, double a, double b, double size = 1) {
  const bool good = std::abs(a - b) <= 8 * std::numeric_limits<double>::epsilon() * size;
  if (!good) std::printf("%s: %.17g and %.17g\n", what, a, b);
  return good;
}

std::vector<Point> points(const Table& table, const char* names, const std::string& name, const char* x,
                          const char* y) {
  const auto all = table.texts(names);
  const auto xs = table.numbers(x), ys = table.numbers(y);
  std::vector<Point> found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] == name) found.emplace_back(xs[i], ys[i]);
  }
  if (found.empty()) throw std::runtime_error("no " + name + " in the figure's table");
  return found;
}

Point place(const Table& places, const char* name) { return points(places, "point", name, "x", "y").front(); }
Point arrow(const Table& lines, const char* name) { return points(lines, "line", name, "dx", "dy").front(); }

// LG03 (3.1), (3.5).
bool contact_surface(const fs::path& folder) {
  const Table point = contensou::read_table(folder / "fig01.tsv");
  const auto value = [&point](const char* column) { return point.numbers(column).at(0); };
  const double rho = value("rho"), phi = value("phi"), r = value("r"), theta = value("theta"),
               pole = value("pole");
  bool good = close("fig01: (3.1), first", rho * std::cos(phi), r * std::sin(theta));
  good = close("fig01: (3.1), second", rho * std::sin(phi) + r * std::cos(theta), pole) && good;

  // w/(|ω|R) = (v − ωρ sin φ) e1 + ωρ cos φ e2
  const Point w = arrow(contensou::read_table(folder / "fig01_lines.tsv"), "w");
  good = close("fig01: w1", w.real(), pole - rho * std::sin(phi)) && good;
  good = close("fig01: w2", w.imag(), rho * std::cos(phi)) && good;
  return close("fig01: (3.5)", std::abs(w), r) && good;
}

constexpr double a1 = 3, a2 = 16, r1 = 15, r2 = 5;  // LG03 5.4 [mm]

// In every position, the lowest of what is drawn is the lowest point of one of the two spheres: nothing else
// touches the floor. The spheres are drawn as polygons whose chords span at most 2π/96: their middle is
// further in than the sphere by the sagitta, a corner is on it.
bool nothing_else_touches(const Table& curves) {
  const double sagitta = r1 * (1 - std::cos(std::numbers::pi / 96));
  bool good = true;
  for (int degrees = 0; degrees <= 180; ++degrees) {
    const double theta = degrees * std::numbers::pi / 180;
    double lowest = 1e9;
    for (const char* part : {"body", "stick"}) {
      for (const Point& p : points(curves, "curve", part, "x", "y")) {
        if (p.real() > 21) continue;  // the other top
        const Point from_s = p - Point(0, r1 - a1);
        lowest = std::min(lowest, from_s.imag() * std::cos(theta) + from_s.real() * std::sin(theta));
      }
    }
    const double spheres = std::min(a1 * std::cos(theta) - r1, a2 * std::cos(theta) - r2);
    if (lowest < spheres - 1e-12 || lowest > spheres + sagitta) {
      std::printf("fig07: at %d° the outline reaches down to %g mm, the spheres to %g mm\n", degrees, lowest,
                  spheres);
      good = false;
    }
  }
  return good;
}

// LG03 5.4, (5.10) to (5.14).
bool tippe_top(const fs::path& folder) {
  const Table places = contensou::read_table(folder / "fig07a.tsv");
  const Table lines = contensou::read_table(folder / "fig07a_lines.tsv");
  const Point s = place(places, "S"), m = place(places, "M"), n = place(places, "N");
  const double cos_theta = ((n - m) / std::abs(n - m)).imag();
  bool good = close("fig07: a1", std::abs(m - s), a1, 100);
  good = close("fig07: a2", std::abs(n - s), a2, 100) && good;
  good = close("fig07: S, M, N in line", std::imag((m - s) * std::conj(n - s)), 0, 100) && good;
  good = close("fig07: g_N1", std::abs(arrow(lines, "g_n1")), s.imag() + a1 * cos_theta - r1, 100) && good;
  good = close("fig07: g_N2", std::abs(arrow(lines, "g_n2")), s.imag() + a2 * cos_theta - r2, 100) && good;
  good = close("fig07: M' under C", place(places, "M_floor").real(), place(places, "C").real(), 100) && good;
  return nothing_else_touches(contensou::read_table(folder / "fig07b_curves.tsv")) && good;
}

constexpr double drawn_length = 1.28;

// An orthonormal frame in parallel projection: the squares of its three complex numbers sum to nought
// (Gauss), the squares of their lengths to 2.
bool euler_angles(const fs::path& folder) {
  const Table lines = contensou::read_table(folder / "fig08_lines.tsv");
  const std::vector<std::vector<const char*>> frames = {
      {"e1_1", "e2_1", "e3_1"}, {"e1_2", "e2_2", "e3_1"}, {"e1_2", "e2_3", "e3_4"}, {"e1_4", "e2_4", "e3_4"}};
  bool good = true;
  for (const auto& frame : frames) {
    Point squares = 0;
    double lengths = 0;
    for (const char* name : frame) {
      squares += arrow(lines, name) * arrow(lines, name);
      lengths += std::norm(arrow(lines, name));
    }
    good = close("fig08: Gauss's theorem", std::abs(squares), 0, 4) && good;
    good = close("fig08: sum of squares", lengths, 2 * drawn_length * drawn_length, 4) && good;
  }
  return good;
}

// LG03 5.5: the regions by their inequalities. The critical spin is within the two decades that the map looks
// at where the hyperbola is not nearer than this.
constexpr double clear_of_hyperbola = 0.01;
bool magnus(const fs::path& folder) {
  const Table borders = contensou::read_table(folder / "fig11.tsv");
  bool good = true;
  for (const Point& p : points(borders, "line", "hyperbola", "h_over_r", "i3_over_i1")) {
    good = close("fig11: h/r = I1/I3", p.real() * p.imag(), 1) && good;
  }
  const Table map = contensou::read_table(folder / "fig11_roots.tsv");
  const auto regions = map.texts("region");
  const auto x = map.numbers("h_over_r"), y = map.numbers("i3_over_i1");
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (std::abs(x[i] * y[i] - 1) < clear_of_hyperbola) continue;
    const bool below = x[i] * y[i] < 1;
    const std::string expected = x[i] < 1 ? (below ? "IV" : "III") : (below ? "I" : "II");
    if (regions[i] != expected) {
      std::printf("fig11: h/r = %g, I3/I1 = %g is in %s, by the roots in %s\n", x[i], y[i], expected.c_str(),
                  regions[i].c_str());
      good = false;
    }
  }
  return good;
}

const std::map<std::string, bool (*)(const fs::path&)> drawings = {
    {"fig01", contact_surface}, {"fig07", tippe_top}, {"fig08", euler_angles}, {"fig11", magnus}};

}  // namespace

bool is_drawing(const std::string& figure) { return drawings.contains(figure); }

bool geometry_holds(const std::string& figure, const fs::path& folder) { return drawings.at(figure)(folder); }
