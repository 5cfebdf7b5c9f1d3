#include "contensou/scene/grid.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "contensou/text/name.hpp"
#include "contensou/text/number.hpp"
#include "contensou/text/quoted.hpp"

namespace contensou {
namespace {

constexpr const char* expected =
    "expected KEY=A:B:N, KEY=A:B:N:log or KEY=V1,V2,..., such as initial.psi_dot=60:250:20";

[[noreturn]] void refuse(std::string_view key, const std::string& what) {
  throw SceneError("--vary " + shortened(key) + ": " + what);
}

/// The parts of a text between separators that stand in no string, array or table.
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts{""};
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == separator && depth == 0 && quote == 0) {
      parts.emplace_back();
      continue;
    }
    parts.back() += c;
    if (quote != 0) {
      if (c == '\\' && quote == '"' && i + 1 < text.size()) {
        parts.back() += text[++i];
      } else if (c == quote) {
        quote = 0;
      }
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return parts;
}

/// In long double, so that what is round in decimals comes out so: 0.1:0.3:3 has 0.2, 1e-6:1e-3:4:log has
/// 1e-5.
struct Range {
  long double from, to;
  std::size_t points;
};

/// Evenly spaced.
double linear(const Range& range, std::size_t i) {
  const auto last = static_cast<long double>(range.points - 1), at = static_cast<long double>(i);
  return static_cast<double>((range.from * (last - at) + range.to * at) / last);
}

/// Even ratios.
double geometric(const Range& range, std::size_t i) {
  const auto last = static_cast<long double>(range.points - 1), at = static_cast<long double>(i);
  const long double from = std::log10(std::abs(range.from)), to = std::log10(std::abs(range.to));
  const long double size = std::pow(10.0L, (from * (last - at) + to * at) / last);
  return static_cast<double>(std::copysign(size, range.from));
}

std::vector<std::string> values_between(std::string_view key, const std::vector<std::string>& parts) {
  Range range{};
  for (const auto& [text, number] : {std::pair(&parts[0], &range.from), std::pair(&parts[1], &range.to)}) {
    if (!parse(*text, *number)) refuse(key, in_quotes(*text) + " is no finite number; " + expected);
  }
  if (!parse(parts[2], range.points) || range.points < 2 || range.points > most_runs)
    refuse(key, in_quotes(parts[2]) + " is no number of points; expected a whole number from 2 to " +
                    std::to_string(most_runs));
  const bool even_ratios = parts.size() == 4;
  if (even_ratios && parts[3] != "log") refuse(key, in_quotes(parts[3]) + " is no spacing; expected log");
  if (even_ratios && (range.from == 0 || range.to == 0 || (range.from < 0) != (range.to < 0)))
    refuse(key, in_quotes(parts[0] + ':' + parts[1]) +
                    " has no even ratios; expected two numbers of one sign, neither of them 0");

  std::vector<std::string> values{to_text(static_cast<double>(range.from))};
  for (std::size_t i = 1; i + 1 < range.points; ++i)
    values.push_back(to_text(even_ratios ? geometric(range, i) : linear(range, i)));
  values.push_back(to_text(static_cast<double>(range.to)));
  return values;
}

std::vector<std::string> listed_values(std::string_view key, std::string_view text) {
  std::vector<std::string> values = split(text, ',');
  std::set<std::string_view> seen;
  for (const std::string& value : values) {
    if (value.find_first_not_of(" \t") == std::string::npos)
      refuse(key, "a value of " + in_quotes(text) + " is empty; " + expected);
    if (!seen.insert(value).second) refuse(key, in_quotes(value) + " stands twice; expected each value once");
  }
  return values;
}

/// Whether setting one key would remove the other.
bool covers(std::string_view upper, std::string_view lower) {
  return lower.starts_with(upper) && (lower.size() == upper.size() || lower[upper.size()] == '.');
}

}  // namespace

GridAxis parse_axis(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw SceneError("--vary: " + in_quotes(text) + (equals == 0 ? " has no key; " : " has no '='; ") +
                     expected);
  const std::string_view key = text.substr(0, equals), values = text.substr(equals + 1);
  if (split(values, ',').size() == 1) {
    // One word may have a colon in it, such as power:2; numbers on both sides of one are a range left
    // unfinished.
    const std::vector<std::string> parts = split(values, ':');
    double ignored = 0;
    if (parts.size() == 3 || parts.size() == 4) return {std::string(key), values_between(key, parts)};
    if (parts.size() > 4 || (parts.size() == 2 && parse(parts[0], ignored)))
      refuse(key, in_quotes(values) + " is no range; " + expected);
  }
  return {std::string(key), listed_values(key, values)};
}

std::size_t Grid::size() const {
  std::size_t runs = 1;
  for (const GridAxis& axis : axes) runs *= axis.values.size();
  return runs;
}

std::vector<std::string> Grid::values(std::size_t run) const {
  std::vector<std::string> values(axes.size());
  for (std::size_t i = axes.size(); i-- > 0;) {
    const std::vector<std::string>& all = axes[i].values;
    values[i] = all[run % all.size()];
    run /= all.size();
  }
  return values;
}

Grid make_grid(std::vector<GridAxis> axes) {
  std::size_t runs = 1;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string& key = axes[i].key;
    for (std::size_t j = 0; j < i; ++j) {
      const std::string& other = axes[j].key;
      if (key == other) refuse(key, "stands twice; expected each key once");
      if (covers(key, other) || covers(other, key))
        refuse(key, "and --vary " + shortened(other) + " undo each other; expected one of them");
    }
    // Both are at most most_runs: their product fits.
    runs *= axes[i].values.size();
    if (runs > most_runs)
      refuse(key, "makes more than " + std::to_string(most_runs) + " runs; expected fewer");
  }
  return {std::move(axes)};
}

SceneDocument at(const Grid& grid, std::size_t run, SceneDocument document) {
  const std::vector<std::string> values = grid.values(run);
  for (std::size_t i = 0; i < values.size(); ++i) set_value(document, grid.axes[i].key + '=' + values[i]);
  return document;
}

std::string describe(const Grid& grid, std::size_t run) {
  const std::vector<std::string> values = grid.values(run);
  std::string text = "run " + std::to_string(run);
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? " (" : ", ") + shortened(grid.axes[i].key) + '=' + shortened(values[i]);
  return values.empty() ? text : text + ')';
}

}  // namespace contensou
