#include "contensou/scene/reader.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

const SceneValue* SceneReader::find(std::string_view key) {
  known_.emplace(key);
  const auto entry = document_.values.find(key);
  return entry == document_.values.end() ? nullptr : &entry->second;
}

void SceneReader::miss(std::string_view key, std::string_view expected) {
  if (missing_.empty())
    missing_ = document_.file + ": " + std::string(key) + " is missing; expected " + std::string(expected);
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
  if (number == nullptr || std::isnan(*number)) refuse(key, "is not a number", range.expected);
  if (std::isinf(*number)) refuse(key, "is not finite", range.expected);
  if (*number < range.least || *number > range.most || (*number == range.least && !range.least_too))
    refuse(key, "is out of range", range.expected);
  return *number;
}

double SceneReader::number(std::string_view key, const Range& range) {
  const std::optional<double> value = optional_number(key, range);
  if (!value) miss(key, range.expected);
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
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

void SceneReader::unused(std::string_view key, std::string_view by) {
  if (find(key) == nullptr) return;
  refuse(key, "is not used by " + std::string(by),
         "no such key (--unset " + std::string(key) + " removes it)");
}

std::string SceneReader::expected_beside(std::string_view key) const {
  const std::string_view table = table_of(key);
  std::string keys;
  std::string tables;
  for (const std::string& known : known_) {
    const std::string_view its_table = table_of(known);
    if (its_table == table) keys += (keys.empty() ? "" : ", ") + known.substr(table.size());
    const std::string title = '[' + std::string(its_table.substr(0, its_table.size() - 1)) + ']';
    if (tables.find(title) == std::string::npos) tables += (tables.empty() ? "" : ", ") + title;
  }
  return keys.empty() ? "keys in " + tables : "one of " + keys;
}

void SceneReader::finish() const {
  // The first in the file; those of --set stand before it.
  const SceneDocument::Values::value_type* unknown = nullptr;
  for (const auto& entry : document_.values) {
    if (known_.contains(entry.first)) continue;
    if (unknown == nullptr || entry.second.line < unknown->second.line) unknown = &entry;
  }
  if (unknown != nullptr) {
    throw SceneError(where(document_, unknown->first, unknown->second) + ": unknown key, value " +
                     unknown->second.text + "; expected " + expected_beside(unknown->first));
  }
  if (!missing_.empty()) throw SceneError(missing_);
}

}  // namespace contensou
