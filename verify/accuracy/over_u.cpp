#include "over_u.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "contenders.hpp"
#include "contensou/output/table.hpp"
#include "errors.hpp"
#include "quantities.hpp"
#include "series_oracle.hpp"

namespace accuracy {
namespace {

constexpr int bins_per_decade = 10;

/// The stored rows near the seam, and Gauss's series on either side of them.
std::vector<ReferenceRow> exact_rows(double n, const std::filesystem::path& stored) {
  std::vector<ReferenceRow> rows;
  for (ReferenceRow& row : read_reference(stored)) {
    if (row.u > 0.5 && row.u < 2) rows.push_back(std::move(row));
  }
  for (const bool outwards : {false, true}) {
    for (ReferenceRow& row : series_scan(n, outwards)) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

void tabulate_over_u(const std::filesystem::path& reference, const std::filesystem::path& data) {
  contensou::Table table{
      {"Largest relative error in each tenth of a decade of u, for several ways to compute the two laws",
       "quantity: phi = f/sqrt(1+u^2), xi = f', eta = f - u f'; methods as in accuracy.tsv",
       "u: middle of the tenth; points: values of u in it, 200 a decade and those of reference_data/accuracy "
       "between 1/2 and 2; error: the largest"},
      {"pressure", "method", "quantity", "u", "points", "error"},
      {}};
  const std::vector<Contender> all = contenders();
  for (const std::string pressure : {"uniform", "hertz"}) {
    const auto rows =
        exact_rows(pressure == "uniform" ? 0 : 0.5, reference / "accuracy" / (pressure + ".tsv"));
    std::vector<double> u;
    for (const ReferenceRow& row : rows) u.push_back(row.u);
    for (const Contender& contender : all) {
      if (contender.pressure != pressure) continue;
      const std::vector<Values> values = contender.evaluate(u);
      for (const Quantity& quantity : quantities) {
        if (quantity.value == &Values::second) continue;
        std::map<long, ErrorSummary> bins;
        for (std::size_t i = 0; i < rows.size(); ++i) {
          bins[std::lround(bins_per_decade * std::log10(u[i]))].add(
              u[i], relative_error(values[i].*quantity.value, rows[i].*quantity.exact));
        }
        for (const auto& [bin, errors] : bins) {
          table.add({pressure, contender.method, quantity.name,
                     std::pow(10.0, static_cast<double>(bin) / bins_per_decade),
                     static_cast<double>(errors.points()), errors.max()});
        }
      }
    }
  }
  contensou::write_table(table, data / "accuracy_over_u.tsv");
}

}  // namespace accuracy
