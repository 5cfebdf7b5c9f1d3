// The one place that knows the TOML parser.
#define TOML_HEADER_ONLY 1
// toml++ 3.3 asserts, in a debug build, that what follows '[' begins a key, before it reports that it does
// not: "[.]" is to be an error and not the end of the program.
#define TOML_ASSERT(expr) static_assert(true)
#include "contensou/scene/document.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "contensou/text/number.hpp"
#include "contensou/text/quoted.hpp"

namespace contensou {
namespace {

/// No scene needs more parts in a key. The parser keeps a level of tables for each, and takes them down again
/// by recursion, so more of them than the stack can bear must not reach it: 128 tables in a value of 256
/// levels (its own limit) of this many parts each are harmless.
constexpr int most_key_parts = 100;
/// Levels of tables in a scene.
constexpr int most_levels = 8;

[[noreturn]] void refuse(std::string_view file, std::size_t line, const std::string& what) {
  throw SceneError(std::string(file) + ':' + std::to_string(line) + ": " + what);
}

/// Where the string that begins at `begin` ends: behind its last quote, or at the end of the line for one
/// that is not closed, which is not TOML and the parser's to report.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string three(3, quote);
  const bool many_lines = text.substr(begin, 3) == three;
  const std::string_view end = std::string_view(three).substr(0, many_lines ? 3 : 1);
  for (std::size_t i = begin + end.size(); i < text.size(); ++i) {
    if (text.substr(i, end.size()) == end) return i + end.size();
    if (text[i] == '\n' && !many_lines) return i;
    if (text[i] == '\\' && quote == '"') ++i;
  }
  return text.size();
}

/// Throws where a key has more than most_key_parts parts: counts dots outside strings and comments.
void require_short_keys(std::string_view text, std::string_view file) {
  int dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(text, i);
    } else if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else {
      if (std::string_view("\n,=[]{}").find(c) != std::string_view::npos) dots = 0;
      if (c == '.' && ++dots > most_key_parts) {
        refuse(file,
               static_cast<std::size_t>(
                   1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(i), '\n')),
               "a key of more than " + std::to_string(most_key_parts) + " parts");
      }
      ++i;
    }
  }
}

bool is_bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// All entries as numbers, or as strings; none where they are neither, or both.
std::optional<std::vector<double>> numbers(const toml::array& array) {
  std::vector<double> values;
  for (const toml::node& node : array) {
    const std::optional<double> number = node.is_number() ? node.value<double>() : std::nullopt;
    if (!number) return {};
    values.push_back(*number);
  }
  return values;
}
std::optional<std::vector<std::string>> strings(const toml::array& array) {
  std::vector<std::string> values;
  for (const toml::node& node : array) {
    if (!node.is_string()) return {};
    values.push_back(node.as_string()->get());
  }
  return values;
}

/// An array as a message shows it, its first entries where it is long.
template <class Value, class Text>
std::string listed(const std::vector<Value>& values, const Text& text) {
  constexpr std::size_t most = 6;
  std::string shown = "[";
  for (std::size_t i = 0; i < std::min(most, values.size()); ++i)
    shown += (i == 0 ? "" : ", ") + text(values[i]);
  return shown + (values.size() > most ? ", ...]" : "]");
}

/// The value as plain data; tables with something in them are the caller's.
SceneValue plain(const toml::node& node, int line) {
  if (const auto* text = node.as_string()) return {text->get(), in_quotes(text->get()), line};
  if (const auto* number = node.as_floating_point()) return {number->get(), to_text(number->get()), line};
  if (const auto* truth = node.as_boolean()) return {truth->get(), truth->get() ? "true" : "false", line};
  if (const auto* whole = node.as_integer())
    return {static_cast<double>(whole->get()), std::to_string(whole->get()), line};
  if (const auto* array = node.as_array()) {
    if (auto values = numbers(*array)) {
      const std::string text = listed(*values, [](double x) { return to_text(x); });
      return {std::move(*values), text, line};
    }
    if (auto values = strings(*array)) {
      const std::string text = listed(*values, [](const std::string& x) { return in_quotes(x); });
      return {std::move(*values), text, line};
    }
  }
  std::ostringstream text;
  node.visit([&](const auto& kind) { text << kind; });
  return {std::monostate(), shortened(text.str()), line};
}

/// Adds all values of a table under "PREFIX.". Values from `--set` have no line.
void flatten(const toml::table& table, const std::string& prefix, int level, bool with_lines,
             SceneDocument& document) {
  for (const auto& [key, node] : table) {
    const std::string name = prefix + (is_bare(key.str()) ? std::string(key.str()) : in_quotes(key.str()));
    const int line = with_lines ? static_cast<int>(key.source().begin.line) : 0;
    const toml::table* inner = node.as_table();
    if (inner != nullptr) document.tables.emplace(name, line);
    if (inner == nullptr || inner->empty()) {
      document.values[name] = plain(node, line);
    } else if (level < most_levels) {
      flatten(*inner, name + '.', level + 1, with_lines, document);
    } else {
      const std::string what = shortened(name) + ": tables nested deeper than " + std::to_string(most_levels);
      if (with_lines) refuse(document.file, static_cast<std::size_t>(line), what);
      throw SceneError("--set " + what);
    }
  }
}

/// A key and all keys below it; how many of them had values.
std::size_t erase(SceneDocument& document, std::string_view key) {
  const std::string below = std::string(key) + '.';
  const auto is_of_key = [&](const auto& entry) {
    return entry.first == key || entry.first.starts_with(below);
  };
  std::erase_if(document.tables, is_of_key);
  return std::erase_if(document.values, is_of_key);
}

void require_dotted_name(std::string_view key, std::string_view option) {
  for (std::size_t begin = 0; begin <= key.size();) {
    const std::size_t end = std::min(key.find('.', begin), key.size());
    if (!is_bare(key.substr(begin, end - begin)))
      throw SceneError(std::string(option) + ": " + in_quotes(key) +
                       " is no key; expected a dotted name such as contact.body.mu");
    begin = end + 1;
  }
}

/// A document with `text` as its one value, if it is a TOML value, whole and alone.
std::optional<toml::table> as_toml(const std::string& text) {
  if (text.find_first_of("\r\n") != std::string::npos) return {};
  require_short_keys(text, "--set");
  try {
    // Within brackets a comment swallows the closing one, so that none is lost without a word.
    const toml::table listed = toml::parse("value = [" + text + "]");
    const toml::array* list = listed["value"].as_array();
    if (list == nullptr || list->size() != 1) return {};
    return toml::parse("value = " + text);
  } catch (const toml::parse_error&) {
    return {};
  }
}

}  // namespace

SceneDocument parse_document(std::string_view text, std::string_view name) {
  SceneDocument document{printable(name), {}, {}};
  require_short_keys(text, document.file);
  try {
    flatten(toml::parse(text), "", 1, true, document);
  } catch (const toml::parse_error& error) {
    refuse(document.file, error.source().begin.line,
           printable(error.description()) + "; expected TOML, such as mu = 0.3");
  }
  return document;
}

SceneDocument read_document(const std::filesystem::path& path) {
  const std::string name = printable(path.string());
  std::ifstream in(path, std::ios::binary);
  std::string text(largest_scene + 1, '\0');
  if (in) in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!in.is_open() || in.bad() || (in.fail() && !in.eof()))
    throw SceneError(name + ": cannot be read; expected a scene file");
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > largest_scene)
    throw SceneError(name + ": longer than " + std::to_string(largest_scene) +
                     " bytes; expected a scene file");
  return parse_document(text, path.string());
}

void set_value(SceneDocument& document, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw SceneError("--set: " + in_quotes(assignment) + " has no '='; expected KEY=VALUE");
  const std::string key(assignment.substr(0, equals));
  const std::string text(assignment.substr(equals + 1));
  require_dotted_name(key, "--set");

  const std::optional<toml::table> parsed = as_toml(text);
  if (!parsed && text.find_first_of("\"'[{") == 0)
    throw SceneError("--set " + key + ": " + in_quotes(text) + " is begun like a TOML value and is none");
  erase(document, key);
  const toml::node* node = parsed ? parsed->get("value") : nullptr;
  if (node != nullptr && node->is_table()) document.tables[key] = 0;
  if (node == nullptr) {
    document.values[key] = {text, in_quotes(text)};
  } else if (const toml::table* table = node->as_table(); table != nullptr && !table->empty()) {
    flatten(*table, key + '.', 1, false, document);
  } else {
    SceneValue value = plain(*node, 0);
    if (!node->is_string()) value.text = shortened(text);  // as it was typed
    document.values[key] = std::move(value);
  }
}

void unset_value(SceneDocument& document, std::string_view key) {
  require_dotted_name(key, "--unset");
  if (erase(document, key) == 0)
    throw SceneError("--unset: " + in_quotes(key) + " is not in the scene; expected a key that is");
}

std::string where(const SceneDocument& document, std::string_view key, const SceneValue& value) {
  const std::string name = shortened(key);
  return value.line == 0 ? "--set " + name : document.file + ':' + std::to_string(value.line) + ": " + name;
}

}  // namespace contensou
