#include "reference.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "contensou/output/table.hpp"

namespace accuracy {
namespace {

Quad parse(const std::string& text, const std::filesystem::path& path) {
  try {
    return Quad(text);
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() + ": '" + text + "' is not a number");
  }
}

}  // namespace

std::vector<ReferenceRow> read_reference(const std::filesystem::path& path) {
  const contensou::Table table = contensou::read_table(path);
  bool ranged = false;
  for (const std::string& name : table.columns) ranged = ranged || name == "range";
  const std::size_t range = ranged ? table.column("range") : 0;
  const std::size_t u = table.column("u");
  const std::size_t phi = table.column("phi");
  const std::size_t xi = table.column("xi");
  const std::size_t eta = table.column("eta");
  const std::size_t f2 = table.column("f2");
  std::vector<ReferenceRow> rows;
  rows.reserve(table.rows.size());
  for (const auto& cells : table.rows) {
    ReferenceRow row{};
    if (ranged) row.range = cells[range];
    row.u = std::strtod(cells[u].c_str(), nullptr);
    row.phi = parse(cells[phi], path);
    row.xi = parse(cells[xi], path);
    row.eta = parse(cells[eta], path);
    row.second = parse(cells[f2], path);
    const Quad exact_u = row.u;
    if (std::isinf(row.u)) {
      row.second = 0;
    } else if (row.u > 1) {
      row.second /= exact_u * exact_u * exact_u;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

double reference_exponent(const std::filesystem::path& path) {
  constexpr std::string_view key = "n = ";
  for (const std::string& comment : contensou::read_table(path).comments) {
    if (comment.starts_with(key)) return std::strtod(comment.c_str() + key.size(), nullptr);
  }
  throw std::runtime_error(path.string() + ": no comment line 'n = ...'");
}

std::map<std::string, std::string> range_intervals(const std::filesystem::path& path) {
  constexpr std::string_view key = "range:";
  for (const std::string& comment : contensou::read_table(path).comments) {
    if (!comment.starts_with(key)) continue;
    std::istringstream words(comment.substr(key.size()));
    std::map<std::string, std::string> intervals;
    for (std::string name, lower, upper; words >> name >> lower >> upper;) {
      intervals[name] = lower + " " + upper;
    }
    return intervals;
  }
  throw std::runtime_error(path.string() + ": no comment line 'range: ...'");
}

}  // namespace accuracy
