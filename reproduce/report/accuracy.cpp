#include "accuracy.hpp"

#include <fmt/format.h>

#include <cmath>

#include "html.hpp"
#include "names.hpp"
#include "number.hpp"
#include "selection.hpp"

namespace report {
namespace {

// Steps of colour: what this library promises; three digits lost; half of all digits; beyond.
std::string_view step(double ulp) {
  if (ulp <= 4) return "fine";
  if (ulp <= 1e3) return "fair";
  if (ulp <= 1e8) return "poor";
  return "lost";  // and where it is not finite
}

// Two digits are enough to compare; three places before the point are easier to read than a power of ten.
std::string short_ulp(double ulp) {
  if (!std::isfinite(ulp)) return std::isnan(ulp) ? "NaN" : "∞";
  return ulp >= 99.5 && ulp < 999.5 ? fmt::format("{:.0f}", ulp) : rounded(ulp, 2);
}

// "[5e-324, 1e-6)" with its powers of ten raised.
std::string interval(const std::string& text) {
  const std::size_t comma = text.find(", ");
  if (comma == std::string::npos || text.size() < comma + 4) return escape(text);
  const std::string lower = text.substr(1, comma - 1);
  const std::string upper = text.substr(comma + 2, text.size() - comma - 3);
  return fmt::format("{}{}, {}{}", escape(text.substr(0, 1)), unrounded(lower), unrounded(upper),
                     escape(text.substr(text.size() - 1)));
}

std::string error_cell(const Selection& row) {
  if (row.empty()) return "<td></td>";
  const double ulp = row.first("max_ulp");
  std::string title =
      fmt::format("max {} ulp at u = {}; mean {:.2g} ulp; {} values of u", row.text("max_ulp"),
                  row.text("worst_u"), row.first("mean_ulp"), row.text("points"));
  if (row.text("not_finite") != "0") title += fmt::format(", {} not finite", row.text("not_finite"));
  return fmt::format("<td class=\"n {}\" title=\"{}\">{}</td>", step(ulp), escape(title), short_ulp(ulp));
}

std::string one_pressure(const Selection& all, const std::string& pressure) {
  const auto ranges = all.values("range");
  std::string html = fmt::format("<h3>{} pressure</h3>\n", pressure_name(pressure));
  html +=
      "<div class=\"scroll\" tabindex=\"0\"><table class=\"glance\"><thead><tr><th>largest error in ulp</th>";
  for (const std::string& range : ranges) {
    html += fmt::format("<th class=\"n\">{}<small>{}</small></th>", escape(range),
                        interval(all.where("range", range).text("interval")));
  }
  html += "</tr></thead>\n";
  for (const std::string& quantity : all.values("quantity")) {
    const Selection of_quantity = all.where("quantity", quantity);
    html += fmt::format("<tbody><tr class=\"group\"><th>{}</th><td colspan=\"{}\"></td></tr>\n",
                        quantity_name(quantity), ranges.size());
    for (const std::string& method : of_quantity.values("method")) {
      const Selection of_method = of_quantity.where("method", method);
      html += fmt::format("<tr><th scope=\"row\">{}</th>", method_name(method));
      for (const std::string& range : ranges) html += error_cell(of_method.where("range", range));
      html += "</tr>\n";
    }
    html += "</tbody>\n";
  }
  return html + "</table></div>\n";
}

}  // namespace

std::string accuracy_at_a_glance(const contensou::Table& accuracy) {
  const Selection all(accuracy);
  std::string html =
      "<p class=\"legend\">Largest error over each range of <i>u</i>: <span class=\"fine\">≤ 4 ulp</span> "
      "<span class=\"fair\">≤ 10<sup>3</sup></span> <span class=\"poor\">≤ 10<sup>8</sup></span> "
      "<span class=\"lost\">worse, or not finite</span></p>\n";
  for (const std::string& pressure : all.values("pressure")) {
    html += one_pressure(all.where("pressure", pressure), pressure);
  }
  return html;
}

}  // namespace report
