#include "numbers.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>

#include "bad_input.hpp"

namespace cli {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

struct Parsed {
  bool complete;  // all of the text is one number
  bool in_range;  // that a double can hold
  double value;
};

Parsed parse(std::string_view text) {
  std::string_view number = trimmed(text);
  if (number.starts_with('+') && !number.starts_with("+-"))
    number.remove_prefix(1);  // from_chars knows no '+'
  double x = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), x);
  return {error != std::errc::invalid_argument && end == number.data() + number.size(),
          error != std::errc::result_out_of_range, x};
}

}  // namespace

bool is_number(std::string_view text) { return parse(text).complete; }

double to_number(std::string_view text, std::string_view source, std::string_view expected) {
  const auto refuse = [&](std::string_view what) {
    return BadInput(std::string(source) + ": " + in_quotes(text) + ' ' + std::string(what) + "; expected " +
                    std::string(expected));
  };
  const Parsed parsed = parse(text);
  if (!parsed.complete || std::isnan(parsed.value)) throw refuse("is not a number");
  if (!parsed.in_range) throw refuse("is out of the range of a double");
  return parsed.value;
}

void for_each_data_line(std::istream& in, const std::string& name, std::string_view expected,
                        const std::function<void(const Line&)>& use) {
  bool any = false;
  std::string text;
  for (std::size_t number = 1; std::getline(in, text); ++number) {
    const std::string_view content = trimmed(text);
    if (content.empty() || content.starts_with('#')) continue;
    use({name + ':' + std::to_string(number), content});
    any = true;
  }
  if (in.bad()) throw BadInput(name + ": cannot be read; expected " + std::string(expected));
  if (!any) throw BadInput(name + ": no values; expected " + std::string(expected));
}

std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> found;
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    found.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return found;
}

}  // namespace cli
