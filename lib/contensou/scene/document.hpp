#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace contensou {

/// What is wrong with a scene, in one line: where it stands (file and line, or `--set KEY`), the key, the
/// value, what was expected.
struct SceneError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// One value of a scene, and where it came from.
struct SceneValue {
  /// A TOML number (whole or not, also inf and nan), boolean, string, array of numbers (also an empty one) or
  /// of strings; nothing for what no key of a scene takes: other arrays, dates, empty tables.
  std::variant<std::monostate, double, bool, std::string, std::vector<double>, std::vector<std::string>>
      value;
  std::string text;  ///< the value as a message shows it
  int line = 0;      ///< of the file; 0: from `--set`
};

/// A scene file as it is written, before anybody asks what it means: every value under its dotted name, such
/// as "contact.body.mu". Plain data; what the keys mean is read_scene's business (read_scene.hpp).
struct SceneDocument {
  using Values = std::map<std::string, SceneValue, std::less<>>;
  std::string file;  ///< as messages name it
  Values values;
  /// Tables by their dotted names, also empty ones: the line where each is first named; 0: from `--set`.
  std::map<std::string, int, std::less<>> tables;
};

/// Reads TOML 1.0; `file` is what messages call it. Throws SceneError, "FILE:LINE: ...", for what is not
/// TOML, or nested deeper than any scene is. Survives any input of up to largest_scene bytes.
SceneDocument parse_document(std::string_view text, std::string_view file);
/// The same from a file of at most largest_scene bytes; a file that cannot be read is a SceneError, too.
SceneDocument read_document(const std::filesystem::path& path);

inline constexpr std::size_t largest_scene = 1 << 20;  ///< [bytes]

/// "KEY=VALUE": puts a TOML value in the place of whatever stands at KEY (and below it). What is no TOML
/// value counts as a string, so that words need no quotes: "integrator.method=rk4". Throws SceneError.
void set_value(SceneDocument& document, std::string_view assignment);
/// Removes a key, or a table with all its keys; throws SceneError if there is none.
void unset_value(SceneDocument& document, std::string_view key);

/// Where a value stands, and its key: "scene.toml:12: contact.body.mu" or "--set contact.body.mu".
std::string where(const SceneDocument& document, std::string_view key, const SceneValue& value);

}  // namespace contensou
