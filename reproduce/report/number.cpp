#include "number.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace report {

std::optional<double> number(std::string_view text) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return x;
}

std::string unrounded(std::string_view number) {
  if (number == "inf") return "∞";
  if (number == "-inf") return "−∞";
  if (number == "nan" || number == "-nan") return "NaN";
  std::string text(number);
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    const int exponent = std::atoi(text.c_str() + e + 1);
    const std::string mantissa = text.substr(0, e);
    text = (mantissa == "1"    ? ""
            : mantissa == "-1" ? "-"
                               : mantissa + "·") +
           fmt::format("10<sup>{}{}</sup>", exponent < 0 ? "−" : "", std::abs(exponent));
  }
  if (text.front() == '-') text.replace(0, 1, "−");
  return text;
}

std::string rounded(double x, int digits) { return unrounded(fmt::format("{:.{}g}", x, digits)); }

std::string rounded_up(double x, int digits) {
  std::string text = fmt::format("{:.{}g}", x, digits);
  if (std::isfinite(x) && x > 0 && std::strtod(text.c_str(), nullptr) < x) {
    const double last = std::pow(10.0, std::floor(std::log10(x)) - digits + 1);
    text = fmt::format("{:.{}g}", std::strtod(text.c_str(), nullptr) + last, digits);
  }
  return unrounded(text);
}

}  // namespace report
