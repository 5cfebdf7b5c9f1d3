#include "ulp_table.hpp"

#include <cstdio>
#include <string>

#include "contenders.hpp"
#include "contensou/output/table.hpp"
#include "errors.hpp"
#include "quantities.hpp"

namespace accuracy {
namespace {

/// What the library promises of the uniform and the Hertz law, for every double.
constexpr double bound_ulp = 4;

/// The names of the ranges in the order in which they stand in the table.
std::vector<std::string> range_names(const std::vector<ReferenceRow>& rows) {
  std::vector<std::string> names;
  for (const ReferenceRow& row : rows) {
    if (names.empty() || names.back() != row.range) names.push_back(row.range);
  }
  return names;
}

}  // namespace

void measure_ulp(const std::filesystem::path& reference, const std::filesystem::path& data,
                 verify::Record& record) {
  contensou::Table table{
      {"Errors of the uniform and the Hertz law in units in the last place (ulp), for several ways to "
       "compute them",
       "quantity: phi = f/sqrt(1+u^2), xi = f', eta = f - u f', f2 = f''; ranges and intervals of "
       "u as in reference_data/accuracy",
       "max_ulp, mean_ulp against 34 exact digits (0.5 is the best a double can do); mean over finite "
       "values; worst_u: "
       "where the maximum is",
       "not_finite: values that are NaN, or infinite where the law is not; max_ulp is then nan or inf",
       "exact, exact_batch: this library. textbook_ke: complete elliptic integrals K, E from Boost (in "
       "double, and "
       "promoted to long double) and GSL. carlson: R_D from Boost. printed: LG03 (3.14), (3.17), (3.18); "
       "printed_series: "
       "LG03 (2.8), (2.13), (2.14)"},
      {"pressure", "method", "quantity", "range", "interval", "points", "max_ulp", "mean_ulp", "worst_u",
       "not_finite"},
      {}};
  const std::vector<Contender> all = contenders();
  for (const std::string pressure : {"uniform", "hertz"}) {
    const std::filesystem::path stored = reference / "accuracy" / (pressure + ".tsv");
    const std::vector<ReferenceRow> rows = read_reference(stored);
    const auto intervals = range_intervals(stored);
    std::vector<double> u;
    for (const ReferenceRow& row : rows) u.push_back(row.u);
    for (const Contender& contender : all) {
      if (contender.pressure != pressure) continue;
      const std::vector<Values> values = contender.evaluate(u);
      double worst = 0;
      for (const Quantity& quantity : quantities) {
        if (quantity.value == &Values::second && !contender.has_second) continue;
        for (const std::string& range : range_names(rows)) {
          ErrorSummary summary;
          for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i].range == range) {
              summary.add(rows[i].u, ulp_error(values[i].*quantity.value, rows[i].*quantity.exact));
            }
          }
          if (!(summary.max() <= worst)) worst = summary.max();
          table.add({pressure, contender.method, quantity.name, range, intervals.at(range),
                     static_cast<double>(summary.points()), summary.max(), summary.mean(), summary.worst_u(),
                     static_cast<double>(summary.not_finite())});
          if (contender.ours) {
            record.add(
                {.id = "accuracy." + pressure + "." + contender.method + "." + quantity.name + "." + range,
                 .where = contender.method == "exact" ? "contensou/law/" + pressure + ".hpp"
                                                      : std::string("contensou/law/batch.hpp"),
                 .claim = std::string(quantity.name) + " of the " + pressure + " law (" + contender.method +
                          ") is within 4 ulp over the range " + range +
                          ", error in ulp, obtained: where the worst is",
                 .expected = 0,
                 .obtained = summary.worst_u(),
                 .error = summary.max(),
                 .bound = bound_ulp});
          }
        }
      }
      std::printf("  %-8s %-27s worst %.3g ulp\n", pressure.c_str(), contender.method.c_str(), worst);
    }
  }
  contensou::write_table(table, data / "accuracy.tsv");
}

}  // namespace accuracy
