#include "names.hpp"

#include <span>
#include <utility>

#include "html.hpp"

namespace report {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

constexpr Pair quantities[] = {{"phi", "Φ"}, {"xi", "<i>ξ</i>"}, {"eta", "<i>η</i>"}, {"f2", "<i>f</i>″"}};

constexpr Pair pressures[] = {{"uniform", "Uniform"}, {"hertz", "Hertz"}};

constexpr Pair methods[] = {{"exact", "this library"},
                            {"exact_batch", "this library, in batches"},
                            {"textbook_ke_boost", "K, E (Boost)"},
                            {"textbook_ke_boost_promoted", "K, E (Boost, promoted)"},
                            {"textbook_ke_gsl", "K, E (GSL)"},
                            {"carlson_boost", "Carlson (Boost)"},
                            {"printed_series", "series as printed"},
                            {"printed", "as printed"},
                            {"semismooth_newton", "semismooth Newton alone"},
                            {"gauss_seidel", "Gauss–Seidel"},
                            {"modified_newton", "the paper’s Modified Newton"}};

std::string find(std::span<const Pair> words, std::string_view word) {
  for (const auto& [name, text] : words) {
    if (name == word) return std::string(text);
  }
  return escape(word);
}

}  // namespace

std::string quantity_name(std::string_view quantity) { return find(quantities, quantity); }
std::string pressure_name(std::string_view pressure) { return find(pressures, pressure); }
std::string method_name(std::string_view method) { return find(methods, method); }

}  // namespace report
