#include "power_law.hpp"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdio>
#include <string>
#include <vector>

#include "contensou/law/power.hpp"
#include "contensou/output/table.hpp"
#include "errors.hpp"

namespace accuracy {
namespace {

/// What the library promises of PowerLaw.
constexpr double bound_relative = 1e-13;

/// Relative to the exact value, or to the smallest normal number where the exact value is below it.
double error_of(double value, const Quad& exact) {
  if (abs(exact) >= Quad(DBL_MIN) || !std::isfinite(value)) return relative_error(value, exact);
  return static_cast<double>(abs(Quad(value) - exact) / Quad(DBL_MIN));
}

}  // namespace

void measure_power_law(const std::filesystem::path& reference, const std::filesystem::path& data,
                       verify::Record& record) {
  std::vector<std::pair<double, std::filesystem::path>> tables;
  for (const auto& entry : std::filesystem::directory_iterator(reference / "laws")) {
    if (entry.path().filename().string().starts_with("power_") && entry.path().extension() == ".tsv") {
      tables.emplace_back(reference_exponent(entry.path()), entry.path());
    }
  }
  std::sort(tables.begin(), tables.end());

  contensou::Table table{
      {"Errors of PowerLaw, the law of a pressure proportional to (1 - rho^2/R^2)^n, against "
       "reference_data/laws",
       "quantity: phi = f/sqrt(1+u^2), xi = f', eta = f - u f', f2 = f''; max, mean: relative error (of "
       "a subnormal value: relative to the smallest normal number); worst_u: where the maximum is"},
      {"n", "quantity", "points", "max", "mean", "worst_u"},
      {}};
  for (const auto& [n, path] : tables) {
    const contensou::PowerLaw law(n);
    constexpr std::array names{"phi", "xi", "eta", "f2"};
    std::array<ErrorSummary, 4> summaries;
    for (const ReferenceRow& row : read_reference(path)) {
      const auto [phi, xi, eta] = contensou::reduced(law, row.u);
      summaries[0].add(row.u, error_of(phi, row.phi));
      summaries[1].add(row.u, error_of(xi, row.xi));
      summaries[2].add(row.u, error_of(eta, row.eta));
      summaries[3].add(row.u, error_of(law.curvature(row.u, 1.0).vv, row.second));
    }
    const std::string exponent = contensou::to_text(n);
    for (std::size_t q = 0; q < names.size(); ++q) {
      const ErrorSummary& s = summaries[q];
      table.add({n, names[q], static_cast<double>(s.points()), s.max(), s.mean(), s.worst_u()});
      record.add({.id = "accuracy.power." + exponent + "." + names[q],
                  .where = "contensou/law/power.hpp",
                  .claim = std::string(names[q]) + " of PowerLaw(" + exponent +
                           ") has a relative error of at most 1e-13; obtained: where the worst is",
                  .expected = 0,
                  .obtained = s.worst_u(),
                  .error = s.max(),
                  .bound = bound_relative});
    }
    std::printf("  power n = %-8s phi %.2g, xi %.2g, eta %.2g, f2 %.2g relative (%zu pieces)\n",
                exponent.c_str(), summaries[0].max(), summaries[1].max(), summaries[2].max(),
                summaries[3].max(), law.pieces());
  }
  contensou::write_table(table, data / "accuracy_power.tsv");
}

}  // namespace accuracy
