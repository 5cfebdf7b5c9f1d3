#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "contensou/output/file.hpp"
#include "contensou/text/number.hpp"

namespace contensou {

/// A table as it stands in a file: `#` comment lines, one line of column names, rows; tab-separated.
/// Cells are text, so that a table may carry more digits than a double.
struct Table {
  std::vector<std::string> comments;  ///< without the leading "# "
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  using Cell = std::variant<double, std::string>;
  /// Appends one row; numbers are written by `to_text`. Throws std::logic_error if the count of cells is
  /// wrong, std::invalid_argument if a text cell holds a tab or a line break.
  void add(std::initializer_list<Cell> cells);
  void add(const std::vector<Cell>& cells);

  /// The index of a column; throws std::out_of_range naming it if there is none.
  std::size_t column(std::string_view name) const;
  /// A whole column as text or as numbers (std::invalid_argument,
  /// with column and row, where one does not parse).
  std::vector<std::string> texts(std::string_view name) const;
  std::vector<double> numbers(std::string_view name) const;
};

/// The whole table as it stands in a file.
std::string to_text(const Table& table);

/// Writes under a temporary name beside `path`, then renames: a reader never sees half a table. Makes missing
/// folders. Throws std::runtime_error naming the path where that fails.
void write_table(const Table& table, const std::filesystem::path& path);

/// Reads a table; throws std::runtime_error naming file and line where a row does not have one cell a column.
Table read_table(const std::filesystem::path& path);

}  // namespace contensou
