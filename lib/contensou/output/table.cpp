#include "contensou/output/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace contensou {
namespace {

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> cells;
  for (std::size_t start = 0;;) {
    const std::size_t tab = line.find('\t', start);
    cells.emplace_back(line.substr(start, tab - start));
    if (tab == std::string_view::npos) return cells;
    start = tab + 1;
  }
}

void append_line(std::string& text, const std::vector<std::string>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (i > 0) text += '\t';
    text += cells[i];
  }
  text += '\n';
}

}  // namespace

void Table::add(std::initializer_list<Cell> cells) { add(std::vector<Cell>(cells)); }

void Table::add(const std::vector<Cell>& cells) {
  if (cells.size() != columns.size()) {
    throw std::logic_error("table row has " + std::to_string(cells.size()) + " cells, expected " +
                           std::to_string(columns.size()));
  }
  std::vector<std::string> row;
  row.reserve(cells.size());
  for (const Cell& cell : cells) {
    row.push_back(std::holds_alternative<double>(cell) ? to_text(std::get<double>(cell))
                                                       : std::get<std::string>(cell));
    if (row.back().find_first_of("\t\r\n") != std::string::npos) {
      throw std::invalid_argument("table cell holds a tab or a line break: '" + row.back() + "'");
    }
  }
  rows.push_back(std::move(row));
}

std::size_t Table::column(std::string_view name) const {
  const auto it = std::find(columns.begin(), columns.end(), name);
  if (it == columns.end()) throw std::out_of_range("table has no column '" + std::string(name) + "'");
  return static_cast<std::size_t>(it - columns.begin());
}

std::vector<std::string> Table::texts(std::string_view name) const {
  const std::size_t j = column(name);
  std::vector<std::string> cells;
  cells.reserve(rows.size());
  for (const auto& row : rows) cells.push_back(row[j]);
  return cells;
}

std::vector<double> Table::numbers(std::string_view name) const {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::string& cell : texts(name)) {
    double x = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), x);
    if (error != std::errc() || end != cell.data() + cell.size()) {
      throw std::invalid_argument("column '" + std::string(name) + "', row " +
                                  std::to_string(values.size() + 1) + ": '" + cell +
                                  "' is not a number that a double can hold");
    }
    values.push_back(x);
  }
  return values;
}

std::string to_text(const Table& table) {
  std::string text;
  for (const std::string& comment : table.comments) text += comment.empty() ? "#\n" : "# " + comment + '\n';
  append_line(text, table.columns);
  for (const auto& row : table.rows) append_line(text, row);
  return text;
}

void write_table(const Table& table, const std::filesystem::path& path) { write_file(to_text(table), path); }

Table read_table(const std::filesystem::path& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path.string() + ": cannot be opened");
  Table table;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (table.columns.empty() && line.starts_with('#')) {
      table.comments.push_back(
          line.substr(std::min<std::size_t>(line.size(), line.starts_with("# ") ? 2 : 1)));
    } else if (table.columns.empty()) {
      table.columns = split(line);
    } else {
      table.rows.push_back(split(line));
      if (table.rows.back().size() != table.columns.size()) {
        throw std::runtime_error(path.string() + ":" + std::to_string(number) + ": " +
                                 std::to_string(table.rows.back().size()) + " cells, expected " +
                                 std::to_string(table.columns.size()));
      }
    }
  }
  if (in.bad() || table.columns.empty()) throw std::runtime_error(path.string() + ": no table in it");
  return table;
}

}  // namespace contensou
