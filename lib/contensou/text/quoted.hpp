#pragma once

#include <string>
#include <string_view>

namespace contensou {

/// A text as an error message can hold it: on one line, control characters as \xNN.
inline std::string printable(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string shown;
  for (const char character : text) {
    const auto byte = static_cast<unsigned char>(character);
    if (byte < 0x20 || byte == 0x7f) {
      shown += {'\\', 'x', digits[byte / 16], digits[byte % 16]};
    } else {
      shown += character;
    }
  }
  return shown;
}

/// The same, shortened if long.
inline std::string shortened(std::string_view text) {
  constexpr std::size_t longest = 60;
  return printable(text.substr(0, longest)) + (text.size() > longest ? "..." : "");
}

/// A value as an error message shows it: in quotes, on one line, shortened if long.
inline std::string in_quotes(std::string_view value) { return '"' + shortened(value) + '"'; }

}  // namespace contensou
