#pragma once

#include <charconv>
#include <string>

namespace contensou {

/// A number as the shortest text that reads back to the same double,
/// for tables and for messages; infinities are "inf" and "-inf".
inline std::string to_text(double x) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, x);
  return {buffer, result.ptr};
}

}  // namespace contensou
