#include "contensou/scene/reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contensou/text/number.hpp"
#include "contensou/text/quoted.hpp"

namespace contensou {
namespace {

std::string one_of(std::initializer_list<std::string_view> choices) {
  std::string text = choices.size() > 1 ? "one of" : "";
  for (const std::string_view choice : choices) {
    if (!text.empty()) text += ' ';
    text += in_quotes(choice);
  }
  return text;
}

/// "contact.body." of "contact.body.mu".
std::string_view table_of(std::string_view key) { return key.substr(0, key.rfind('.') + 1); }
/// "contact.body" of it.
std::string_view title_of(std::string_view key) {
  const std::string_view table = table_of(key);
  return table.substr(0, table.empty() ? 0 : table.size() - 1);
}

/// What is wrong with a number; empty: nothing.
const char* complaint(double number, const Range& range) {
  if (std::isnan(number)) return "is not a number";
  if (std::isinf(number)) return "is not finite";
  const bool is_out =
      number < range.least || number > range.most || (number == range.least && !range.least_too);
  return is_out ? "is out of range" : "";
}

}  // namespace

const SceneValue* SceneReader::find(std::string_view key) {
  known_.emplace(key);
  const auto entry = document_.values.find(key);
  return entry == document_.values.end() ? nullptr : &entry->second;
}

std::string SceneReader::where_table(std::string_view table) const {
  const auto entry = document_.tables.find(table);
  const bool has_line = entry != document_.tables.end() && entry->second > 0;
  return has_line ? document_.file + ':' + std::to_string(entry->second) : document_.file;
}

void SceneReader::miss(std::string_view key, std::string_view expected) {
  if (!missing_.empty()) return;
  missing_ =
      where_table(title_of(key)) + ": " + std::string(key) + " is missing; expected " + std::string(expected);
}

void SceneReader::refuse(std::string_view key, std::string_view what, std::string_view expected) const {
  const SceneValue& value = document_.values.find(key)->second;
  throw SceneError(where(document_, key, value) + ": " + value.text + ' ' + std::string(what) +
                   "; expected " + std::string(expected));
}

std::optional<double> SceneReader::optional_number(std::string_view key, const Range& range) {
  const SceneValue* value = find(key);
  if (value == nullptr) return {};
  const double* number = std::get_if<double>(&value->value);
  if (number == nullptr) refuse(key, "is not a number", range.expected);
  if (const std::string_view what = complaint(*number, range); !what.empty())
    refuse(key, what, range.expected);
  return *number;
}

double SceneReader::number(std::string_view key, const Range& range) {
  const std::optional<double> value = optional_number(key, range);
  if (!value) miss(key, range.expected);
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::optional<int> SceneReader::optional_whole(std::string_view key, int least, int most) {
  const std::string expected = "a whole number from " + std::to_string(least) + " to " + std::to_string(most);
  const std::optional<double> value =
      optional_number(key, {.least = 1.0 * least, .most = 1.0 * most, .expected = expected.c_str()});
  if (!value) return {};
  if (*value != std::floor(*value)) refuse(key, "is not whole", expected);
  return static_cast<int>(*value);
}

int SceneReader::whole(std::string_view key, int least, int most) {
  const std::optional<int> value = optional_whole(key, least, most);
  if (!value) miss(key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value.value_or(least);
}

void SceneReader::require_length(std::string_view key, std::size_t size, const Length& length) const {
  if (size < length.least || size > length.most)
    refuse(key, "has " + std::to_string(size) + (size == 1 ? " entry" : " entries"), length.expected);
}

std::optional<std::vector<double>> SceneReader::optional_numbers(std::string_view key, const Length& length,
                                                                 const Range& each) {
  const SceneValue* value = find(key);
  if (value == nullptr) return {};
  const auto* numbers = std::get_if<std::vector<double>>(&value->value);
  if (numbers == nullptr) refuse(key, "is not an array of numbers", length.expected);
  require_length(key, numbers->size(), length);
  for (const double number : *numbers) {
    if (const std::string_view what = complaint(number, each); !what.empty())
      refuse(key, "holds " + to_text(number) + ", which " + std::string(what), length.expected);
  }
  return *numbers;
}

std::vector<double> SceneReader::numbers(std::string_view key, const Length& length, const Range& each) {
  const auto values = optional_numbers(key, length, each);
  if (!values) miss(key, length.expected);
  return values.value_or(std::vector<double>());
}

std::optional<Eigen::Vector3d> SceneReader::optional_vector(std::string_view key) {
  const auto values = optional_numbers(key, three);
  if (!values) return {};
  return Eigen::Vector3d((*values)[0], (*values)[1], (*values)[2]);
}

Eigen::Vector3d SceneReader::vector(std::string_view key) {
  const auto value = optional_vector(key);
  if (!value) miss(key, three.expected);
  return value.value_or(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
}

std::optional<std::vector<std::string>> SceneReader::optional_texts(std::string_view key,
                                                                    const Length& length) {
  const SceneValue* value = find(key);
  if (value == nullptr) return {};
  const auto* texts = std::get_if<std::vector<std::string>>(&value->value);
  if (texts == nullptr) refuse(key, "is not an array of strings", length.expected);
  require_length(key, texts->size(), length);
  return *texts;
}

std::vector<std::string> SceneReader::texts(std::string_view key, const Length& length) {
  const auto values = optional_texts(key, length);
  if (!values) miss(key, length.expected);
  return values.value_or(std::vector<std::string>());
}

std::optional<std::string> SceneReader::optional_text(std::string_view key, std::string_view expected) {
  const SceneValue* value = find(key);
  if (value == nullptr) return {};
  if (!is_text(key)) refuse(key, "is not a string", expected);
  return std::get<std::string>(value->value);
}

std::string SceneReader::text(std::string_view key, std::string_view expected) {
  const std::optional<std::string> value = optional_text(key, expected);
  if (!value) miss(key, expected);
  return value.value_or("");
}

std::optional<std::string> SceneReader::optional_choice(std::string_view key,
                                                        std::initializer_list<std::string_view> choices) {
  const std::optional<std::string> value = optional_text(key, one_of(choices));
  if (value && std::find(choices.begin(), choices.end(), *value) == choices.end())
    refuse(key, "is unknown", one_of(choices));
  return value;
}

std::string SceneReader::choice(std::string_view key, std::initializer_list<std::string_view> choices) {
  const std::optional<std::string> value = optional_choice(key, choices);
  if (!value) miss(key, one_of(choices));
  return value.value_or(std::string(*choices.begin()));
}

bool SceneReader::is_text(std::string_view key) const {
  const auto entry = document_.values.find(key);
  return entry != document_.values.end() && std::holds_alternative<std::string>(entry->second.value);
}

bool SceneReader::is_array(std::string_view key) const {
  const auto entry = document_.values.find(key);
  return entry != document_.values.end() && std::holds_alternative<std::vector<double>>(entry->second.value);
}

std::vector<std::string> SceneReader::tables(std::string_view prefix) {
  const std::string below = std::string(prefix) + '.';
  std::vector<std::pair<int, std::string>> found;
  for (auto entry = document_.tables.lower_bound(below);
       entry != document_.tables.end() && entry->first.starts_with(below); ++entry) {
    const std::string name = entry->first.substr(below.size());
    if (name.find_first_of(".\"") != std::string::npos) continue;
    known_tables_.insert(entry->first);
    found.emplace_back(entry->second, name);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [line, name] : found) names.push_back(std::move(name));
  return names;
}

bool SceneReader::has_table(std::string_view table) {
  if (!document_.tables.contains(table)) return false;
  known_tables_.emplace(table);
  return true;
}

void SceneReader::refuse_table(std::string_view table, std::string_view what,
                               std::string_view expected) const {
  throw SceneError(where_table(table) + ": [" + std::string(table) + "] " + std::string(what) +
                   "; expected " + std::string(expected));
}

void SceneReader::refuse_scene(std::string_view what, std::string_view expected) const {
  throw SceneError(document_.file + ": " + std::string(what) + "; expected " + std::string(expected));
}

void SceneReader::unused(std::string_view key, std::string_view by) {
  if (find(key) == nullptr) return;
  refuse(key, "is not used by " + std::string(by),
         "no such key (--unset " + std::string(key) + " removes it)");
}

std::string SceneReader::expected_beside(std::string_view key) const {
  constexpr std::size_t longest = 200;  // of a line that still helps
  const std::string_view table = table_of(key);
  std::string keys;
  std::string tables;
  for (const std::string& known : known_) {
    const std::string_view its_table = table_of(known);
    if (its_table == table) keys += (keys.empty() ? "" : ", ") + known.substr(table.size());
    const std::string title = '[' + std::string(title_of(known)) + ']';
    if (tables.size() < longest && tables.find(title) == std::string::npos)
      tables += (tables.empty() ? "" : ", ") + title;
  }
  if (tables.size() >= longest) tables += " and others";
  return keys.empty() ? "keys in " + tables : "one of " + keys;
}

void SceneReader::finish() const {
  // The first in the file; those of --set stand before it.
  const SceneDocument::Values::value_type* unknown = nullptr;
  for (const auto& entry : document_.values) {
    if (known_.contains(entry.first) || known_tables_.contains(entry.first)) continue;
    if (unknown == nullptr || entry.second.line < unknown->second.line) unknown = &entry;
  }
  if (unknown != nullptr) {
    const std::string title(title_of(unknown->first));
    if (unknown->second.line == 0 && !title.empty() && !document_.tables.contains(title) &&
        !document_.values.contains(title))
      throw SceneError(where(document_, unknown->first, unknown->second) + ": there is no [" +
                       shortened(title) + "]; expected " + expected_beside(unknown->first) +
                       "; or a new table at once: --set " + shortened(title) + "='{key = value, ...}'");
    throw SceneError(where(document_, unknown->first, unknown->second) + ": unknown key, value " +
                     unknown->second.text + "; expected " + expected_beside(unknown->first));
  }
  if (!missing_.empty()) throw SceneError(missing_);
}

}  // namespace contensou
