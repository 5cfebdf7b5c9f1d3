#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "contensou/output/table.hpp"

namespace report {

/// Rows of a table picked by what stands in their columns.
class Selection {
 public:
  explicit Selection(const contensou::Table& table);
  /// Those with `value` in `column`.
  Selection where(std::string_view column, std::string_view value) const;

  std::size_t count() const { return rows_.size(); }
  bool empty() const { return rows_.empty(); }
  const std::string& text(std::string_view column) const;  ///< of the first row
  double first(std::string_view column) const;             ///< of the first row
  /// NaN where one is not a number, or there is none.
  double largest(std::string_view column) const;
  /// Of the cells that are numbers: in tables where NaN stands for "does not apply".
  double largest_there_is(std::string_view column) const;
  double least_there_is(std::string_view column) const;
  /// The different texts of a column, in the order they first appear in.
  std::vector<std::string> values(std::string_view column) const;

 private:
  const contensou::Table* table_;
  std::vector<const std::vector<std::string>*> rows_;
};

}  // namespace report
