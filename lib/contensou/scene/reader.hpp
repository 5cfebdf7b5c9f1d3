#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "contensou/scene/document.hpp"

namespace contensou {

/// The numbers a key takes, and how a message says so.
struct Range {
  double least = -std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::max();
  bool least_too = true;  ///< whether `least` itself is in
  const char* expected = "a finite number";
};

inline constexpr Range positive{.least = 0, .least_too = false, .expected = "a number > 0"};
inline constexpr Range not_negative{.least = 0, .expected = "a number >= 0"};
inline constexpr Range from_0_to_1{.least = 0, .most = 1, .expected = "a number from 0 to 1"};

/// The arrays of numbers or of strings that a key takes, and how a message says so.
struct Length {
  std::size_t least = 1;
  std::size_t most = std::numeric_limits<std::size_t>::max();
  const char* expected = "an array of numbers";
};

inline constexpr Length three{.least = 3, .most = 3, .expected = "an array of three finite numbers"};

/// Reads a document key by key and holds against it what nobody asked for: a class only to keep count. A
/// value that cannot be used is a SceneError at once; a missing one is reported by finish(), after unknown
/// keys, because a key that is misspelt is both. Until then something harmless stands in for it.
class SceneReader {
 public:
  explicit SceneReader(const SceneDocument& document) : document_(document) {}

  bool has(std::string_view key) const { return document_.values.contains(key); }
  /// A number; NaN where it is missing.
  double number(std::string_view key, const Range& range);
  std::optional<double> optional_number(std::string_view key, const Range& range);
  /// A whole number from `least` to `most`; `least` where it is missing.
  int whole(std::string_view key, int least, int most);
  std::optional<int> optional_whole(std::string_view key, int least, int most);
  /// An array of numbers, each in the range; empty where it is missing.
  std::vector<double> numbers(std::string_view key, const Length& length, const Range& each = {});
  std::optional<std::vector<double>> optional_numbers(std::string_view key, const Length& length,
                                                      const Range& each = {});
  /// An array of three; NaN where it is missing.
  Eigen::Vector3d vector(std::string_view key);
  std::optional<Eigen::Vector3d> optional_vector(std::string_view key);
  /// An array of strings; empty where it is missing.
  std::vector<std::string> texts(std::string_view key, const Length& length);
  std::optional<std::vector<std::string>> optional_texts(std::string_view key, const Length& length);
  /// A string; empty where it is missing.
  std::string text(std::string_view key, std::string_view expected);
  std::optional<std::string> optional_text(std::string_view key, std::string_view expected);
  /// One of these strings; the first where it is missing.
  std::string choice(std::string_view key, std::initializer_list<std::string_view> choices);
  std::optional<std::string> optional_choice(std::string_view key,
                                             std::initializer_list<std::string_view> choices);
  /// Whether the value at this key is a string, or an array of numbers.
  bool is_text(std::string_view key) const;
  bool is_array(std::string_view key) const;

  /// The names of tables "[PREFIX.NAME]", in the order in which the file names them; those of `--set` first.
  std::vector<std::string> tables(std::string_view prefix);
  bool has_table(std::string_view table);

  /// Refuses a key that means something elsewhere but not here: "... is not used by law = \"coulomb\"".
  void unused(std::string_view key, std::string_view by);
  /// "WHERE: VALUE WHAT; expected EXPECTED", for a value that is there.
  [[noreturn]] void refuse(std::string_view key, std::string_view what, std::string_view expected) const;
  /// "WHERE: [TABLE] WHAT; expected EXPECTED".
  [[noreturn]] void refuse_table(std::string_view table, std::string_view what,
                                 std::string_view expected) const;
  /// "FILE: WHAT; expected EXPECTED", for what is wrong with no key.
  [[noreturn]] void refuse_scene(std::string_view what, std::string_view expected) const;

  /// To be called last: throws for keys that nobody read, then for missing ones.
  void finish() const;

 private:
  /// The value, noted as read; null where there is none.
  const SceneValue* find(std::string_view key);
  void miss(std::string_view key, std::string_view expected);
  void require_length(std::string_view key, std::size_t size, const Length& length) const;
  /// "FILE:LINE" of a table; "FILE" where it has no line.
  std::string where_table(std::string_view table) const;
  /// The keys that were asked for in the table of an unknown key; else the tables.
  std::string expected_beside(std::string_view key) const;

  const SceneDocument& document_;
  std::set<std::string, std::less<>> known_;
  std::set<std::string, std::less<>> known_tables_;
  std::string missing_;
};

}  // namespace contensou
