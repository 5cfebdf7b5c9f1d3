#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "contensou/text/quoted.hpp"

namespace cli {

using contensou::in_quotes;

/// Whether the whole text reads as a number, NaN and numbers out of range included.
bool is_number(std::string_view text);

/// A number from text such as "0.5", "1e-3", "+2" or "inf", with nothing but spaces around it.
/// Throws BadInput, "SOURCE: VALUE is ...; expected EXPECTED", where
/// it is no number, a NaN, too large or too small for a double.
double to_number(std::string_view text, std::string_view source, std::string_view expected);

/// A line of input and where it stood, such as "standard input:3". The text lives as long as the call.
struct Line {
  std::string source;
  std::string_view text;
};

/// Calls use(line) for each line of a stream that is not blank and no comment (first character '#'); without
/// the blanks around it. Throws BadInput where the stream cannot be read or holds no line of data.
void for_each_data_line(std::istream& in, const std::string& name, std::string_view expected,
                        const std::function<void(const Line&)>& use);

/// The words of a text, between blanks.
std::vector<std::string_view> words(std::string_view text);

}  // namespace cli
