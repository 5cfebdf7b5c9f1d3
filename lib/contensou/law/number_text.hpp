#pragma once

#include <charconv>
#include <string>

namespace contensou {

/// A number as the shortest text that reads back to the same double, for messages about it. (The laws know
/// nothing of output/, which has its own.)
inline std::string number_text(double x) {
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, x);
  return {buffer, result.ptr};
}

}  // namespace contensou
