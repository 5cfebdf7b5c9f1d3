// The curves a figure program has just written against the stored reference curves (25 guaranteed digits from
// interval arithmetic, reference_data/generate/figure_curves.cpp).
//
//   compare_curves FIGURE FRESH REFERENCE       e.g. compare_curves fig05 /tmp/fresh reference_data/figures
//
// A value passes if |value − reference| <= (relative |reference| + absolute) ε, ε =
// 2⁻⁵². The arguments of the curves are exact doubles, so that only the law and the
// operations after it count. Counting each correctly rounded operation and the reading
// of the reference as ε/2 and the laws as 4 ulp <= 4 ε in ξ and η (what they promise):

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "contensou/output/table.hpp"
#include "geometry.hpp"

namespace {

namespace fs = std::filesystem;
using contensou::Table;

struct Bound {
  double relative;  ///< in ε
  double absolute;  ///< in ε
};

constexpr Bound argument{0, 0};  // exact
constexpr Bound law{4.5, 0};     // law 4, reading 1/2
// Contour lines: Φ = vξ + sη, all terms positive: law 4,
// products 1/2, sum 1/2; then quotient, product, reading.
constexpr Bound contour{6.5, 0};
// Direction of sliding: hypot within 1 ulp, quotient, law 4, product, reading.
constexpr Bound disk{6.5, 0};
// LG03 (2.18): 1 − x(3/2 − ...) keeps at least 0.163 of terms that sum to 0.837 with a relative error of 2
// ε: 10.8 ε, halved by the root; root, factor 2/3, reading: 7.4. The outer branch is better conditioned (4).
constexpr Bound printed{7.5, 0};
// The nearest point: what of (force − point) lies across the normal is at most 4 ulp of the force, below 2,
// and moves the point by no more; the law.
constexpr Bound nearest{4.5, 4};
// Turning about the axis: the angle (up to 2π) has a relative error of 1.2 ε, hence cos and sin an absolute
// one of 7.5 ε, and 1 ε of their own.
constexpr Bound turned{5.5, 8.5};

using Columns = std::map<std::string, Bound>;
const std::map<std::string, Columns> bounds = {
    {"fig02a", {{"phi", argument}, {"v", contour}, {"omega_r", contour}}},
    {"fig02b", {{"phi", argument}, {"v", contour}, {"omega_r", contour}}},
    {"fig03a", {{"lambda_t1", disk}, {"lambda_t2", disk}}},
    {"fig03b", {{"lambda_t", law}, {"lambda_tau", law}}},
    {"fig03b_printed", {{"lambda_t", argument}, {"lambda_tau", printed}}},
    {"fig03c",
     {{"lambda_t", argument}, {"lambda_tau", argument}, {"nearest_t", nearest}, {"nearest_tau", nearest}}},
    {"fig04", {{"meridian", argument}, {"lambda_t1", turned}, {"lambda_t2", turned}, {"lambda_tau", law}}},
    {"fig04_printed",
     {{"meridian", argument}, {"lambda_t1", turned}, {"lambda_t2", turned}, {"lambda_tau", printed}}},
    {"fig05a", {{"u", argument}, {"xi_uniform", law}, {"xi_hertz", law}}},
    {"fig05b", {{"inverse_u", argument}, {"eta_uniform", law}, {"eta_hertz", law}}},
    {"fig06a", {{"v", argument}, {"0.125", law}, {"0.25", law}, {"0.5", law}, {"1", law}}},
    {"fig06a_set", {{"v", argument}, {"minus_lambda_t", law}}},
    {"fig06b", {{"gamma_tau", argument}, {"0.125", law}, {"0.25", law}, {"0.5", law}, {"1", law}}},
    {"fig06b_set", {{"gamma_tau", argument}, {"minus_lambda_tau", law}}},
};

bool same_column(const std::string& where, const std::vector<double>& fresh,
                 const std::vector<double>& reference, const Bound& bound) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double worst = -1;  // error/allowed
  std::size_t worst_row = 0, failures = 0;
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const double error = std::abs(fresh[i] - reference[i]);
    const double allowed = (bound.relative * std::abs(reference[i]) + bound.absolute) * epsilon;
    const bool good = error <= allowed;  // false for NaN
    if (!good) ++failures;
    const double share = error == 0              ? 0
                         : !good && !(error > 0) ? std::numeric_limits<double>::infinity()
                                                 : error / allowed;
    if (share > worst) {
      worst = share;
      worst_row = i;
    }
  }
  std::printf("%-28s %s: largest error %.3g of what is allowed\n", where.c_str(),
              failures == 0 ? "good" : "BAD", worst);
  if (failures > 0) {
    std::printf("  %zu values too far; worst in row %zu: %.17g, reference %.17g\n", failures, worst_row + 1,
                fresh[worst_row], reference[worst_row]);
  }
  return failures == 0;
}

bool same_table(const std::string& name, const fs::path& fresh_folder, const fs::path& reference_folder) {
  const Table fresh = contensou::read_table(fresh_folder / (name + ".tsv"));
  const Table reference = contensou::read_table(reference_folder / (name + ".tsv"));
  if (fresh.columns != reference.columns || fresh.rows.size() != reference.rows.size()) {
    std::printf("%s: columns or the number of rows differ from the reference\n", name.c_str());
    return false;
  }
  const Columns& columns = bounds.at(name);
  bool good = true;
  for (const std::string& column : fresh.columns) {
    const std::string where = name + " " + column;
    if (const auto bound = columns.find(column); bound != columns.end()) {
      good = same_column(where, fresh.numbers(column), reference.numbers(column), bound->second) && good;
    } else if (fresh.texts(column) != reference.texts(column)) {
      std::printf("%s: differs from the reference\n", where.c_str());
      good = false;
    }
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: compare_curves FIGURE FRESH REFERENCE\n");
    return 2;
  }
  try {
    const std::string figure = argv[1];
    if (is_drawing(figure)) return geometry_holds(figure, argv[2]) ? 0 : 1;
    int tables = 0;
    bool good = true;
    for (const auto& entry : bounds) {
      if (!entry.first.starts_with(figure)) continue;
      good = same_table(entry.first, argv[2], argv[3]) && good;
      ++tables;
    }
    return good && tables > 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare_curves: %s\n", error.what());
    return 1;
  }
}
