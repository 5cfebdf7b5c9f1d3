#include "selection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "number.hpp"

namespace report {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Selection::Selection(const contensou::Table& table) : table_(&table) {
  for (const auto& row : table.rows) rows_.push_back(&row);
}

Selection Selection::where(std::string_view column, std::string_view value) const {
  const std::size_t j = table_->column(column);
  Selection some = *this;
  std::erase_if(some.rows_, [&](const auto* row) { return (*row)[j] != value; });
  return some;
}

const std::string& Selection::text(std::string_view column) const {
  if (rows_.empty()) throw std::out_of_range("no row to take " + std::string(column) + " from");
  return (*rows_.front())[table_->column(column)];
}

double Selection::first(std::string_view column) const { return number(text(column)).value_or(nan); }

double Selection::largest(std::string_view column) const {
  const std::size_t j = table_->column(column);
  double largest = nan;
  for (const auto* row : rows_) {
    const double x = number((*row)[j]).value_or(nan);
    if (std::isnan(x)) return nan;
    if (!(x <= largest)) largest = x;
  }
  return largest;
}

double Selection::largest_there_is(std::string_view column) const {
  const std::size_t j = table_->column(column);
  double largest = nan;
  for (const auto* row : rows_) largest = std::fmax(largest, number((*row)[j]).value_or(nan));
  return largest;
}

double Selection::least_there_is(std::string_view column) const {
  const std::size_t j = table_->column(column);
  double least = nan;
  for (const auto* row : rows_) least = std::fmin(least, number((*row)[j]).value_or(nan));
  return least;
}

std::vector<std::string> Selection::values(std::string_view column) const {
  const std::size_t j = table_->column(column);
  std::vector<std::string> values;
  for (const auto* row : rows_) {
    if (std::find(values.begin(), values.end(), (*row)[j]) == values.end()) values.push_back((*row)[j]);
  }
  return values;
}

}  // namespace report
