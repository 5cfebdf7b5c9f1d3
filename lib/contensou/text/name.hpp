#pragma once

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace contensou {

/// For the names that stand for pressures and models: std::invalid_argument with the one line
/// "value: expected this".
[[noreturn]] inline void reject(std::string_view value, std::string_view expected) {
  throw std::invalid_argument(std::string(value) + ": expected " + std::string(expected));
}

/// The whole of `text` as a finite number (or integer); false where it is none.
template <class Number>
bool parse(std::string_view text, Number& number) {
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(static_cast<double>(number));
}

/// What stands after `prefix`, if `name` begins with it.
inline bool after(std::string_view prefix, std::string_view name, std::string_view& rest) {
  if (!name.starts_with(prefix)) return false;
  rest = name.substr(prefix.size());
  return true;
}

}  // namespace contensou
