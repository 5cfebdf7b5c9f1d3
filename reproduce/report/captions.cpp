#include "captions.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "contensou/output/table.hpp"
#include "number.hpp"
#include "selection.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

std::string accuracy(const fs::path& data) {
  const Table over_u_table = contensou::read_table(data / "accuracy_over_u.tsv");
  const Table loss_table = contensou::read_table(data / "accuracy_loss.tsv");
  const Selection over_u(over_u_table), loss(loss_table);
  // Where the relative error of η first passes 1 on the way out.
  const auto lost = [&](const char* method) {
    const Selection row = loss.where("method", method)
                              .where("quantity", "eta")
                              .where("towards", "infinity")
                              .where("threshold", "1");
    return row.empty() ? std::string("(never)") : rounded(row.first("u"), 2);
  };
  return fmt::format(
      "Largest relative error in each tenth of a decade of <i>u</i>; the level line is 2<sup>−53</sup>, the "
      "most that "
      "rounding the exact value can cost. This library stays beside it, at most {}, from end to end. Slopes "
      "are digits "
      "lost by cancellation: of <i>η</i> none is left beyond <i>u</i> = {} with K and E, {} with Carlson’s "
      "integral, {} "
      "with (3.18) as printed. The peaks at <i>u</i> = 1 are not rounding: there the series (2.8), (2.13), "
      "(2.14) as "
      "printed are off by up to {}. What is below 10<sup>−17</sup> is drawn there.",
      rounded_up(over_u.where("method", "exact").largest("error"), 2), lost("textbook_ke_boost"),
      lost("carlson_boost"), lost("printed"),
      rounded(over_u.where("method", "printed_series").largest("error"), 2));
}

}  // namespace

std::string caption(const std::string& name, const fs::path& data) {
  static const std::map<std::string, std::string (*)(const fs::path&)> captions{{"accuracy", accuracy}};
  const auto words = captions.find(name);
  return words == captions.end() ? "" : words->second(data);
}

}  // namespace report
