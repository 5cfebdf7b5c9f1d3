#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "figures.hpp"
#include "html.hpp"
#include "sections.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

std::string tile(const std::string& table, const std::string& verdict, const std::string& kind, int count) {
  return fmt::format("<a class=\"tile {}\" href=\"#{}\" data-filter=\"{}\"><b>{}</b> {}</a>\n",
                     count > 0 ? kind : "none", table, verdict, count, verdict);
}

std::string tiles(const Table& table, const std::string& id,
                  const std::vector<std::pair<std::string, std::string>>& verdicts) {
  auto counts = tally(table, "verdict");
  std::string html;
  for (const auto& [verdict, kind] : verdicts) {
    html += tile(id, verdict, kind, counts[verdict]);
    counts.erase(verdict);
  }
  for (const auto& [other, count] : counts) html += tile(id, other, "bad", count);  // not a word of the list
  return html;
}

std::string complaint(const Complaint& c) {
  if (c.claim.empty()) return fmt::format("<li>{}</li>\n", escape(c.text));
  return fmt::format("<li><a href=\"#row-{}\">{}</a></li>\n", escape(c.claim), escape(c.text));
}

std::string verdict(const Evidence& evidence) {
  const bool good = evidence.complaints.empty();
  std::string html = fmt::format(
      "<div class=\"verdict {}\"><p class=\"sentence\">{}</p>\n<p>{}.</p>\n", good ? "good" : "bad",
      good ? "Every claim came out as it should." : "Not everything came out as it should.",
      escape(in_words(evidence)));
  if (!good) {
    constexpr std::size_t shown = 12;
    html += "<ul>";
    for (std::size_t i = 0; i < std::min(shown, evidence.complaints.size()); ++i) {
      html += complaint(evidence.complaints[i]);
    }
    html += "</ul>\n";
    if (evidence.complaints.size() > shown) {
      html += fmt::format("<p>and {} more.</p>\n", evidence.complaints.size() - shown);
    }
  }
  html +=
      "</div>\n<h3>Claims checked by a program</h3><div class=\"tiles\">\n" +
      tiles(
          evidence.claims, "claims",
          {{"holds", "good"}, {"fails", "bad"}, {"fails as known", "warn"}, {"holds unexpectedly", "bad"}}) +
      "</div>\n<h3>Equations and sentences of the paper</h3><div class=\"tiles\">\n" +
      tiles(evidence.ledger, "ledger",
            {{"holds", "good"},
             {"misprint", "warn"},
             {"wrong", "bad"},
             {"imprecise", "warn"},
             {"not checkable", "open"}}) +
      "</div>\n";
  return html;
}

std::string programs(const Evidence& evidence) {
  Table table{{}, {"program", "status", "seconds"}, {}};
  for (const auto& p : evidence.programs)
    table.add({p.program,
               p.status == "0"                   ? "ok"
               : p.status.starts_with("skipped") ? p.status
                                                 : "failed: " + p.status,
               p.seconds});
  return report::table(table, "programs", "Programs of this run", true);
}

// The processor's name as Linux knows it.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

// What was run, and on what.
std::string provenance() {
  const std::string_view build_type = REPORT_BUILD_TYPE;
  return fmt::format("<p>contensou {}, compiled by {}, build type {}. Processor: {}.</p>\n", REPORT_VERSION,
                     escape(REPORT_COMPILER), build_type.empty() ? "none" : escape(std::string(build_type)),
                     escape(processor()));
}

// One pass over the template, so that text filled in is never taken for a placeholder.
std::string fill(std::string_view text, const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string html;
  for (;;) {
    const std::size_t begin = text.find("{{");
    html += text.substr(0, begin);
    if (begin == std::string_view::npos) return html;
    const std::size_t end = text.find("}}", begin);
    const std::string_view name = text.substr(begin + 2, end - begin - 2);
    const auto value =
        std::find_if(values.begin(), values.end(), [name](const auto& entry) { return entry.first == name; });
    if (end == std::string_view::npos || value == values.end()) {
      throw std::runtime_error(fmt::format("template.html: nothing to fill in for '{}'", name));
    }
    html += value->second;
    text.remove_prefix(end + 2);
  }
}

}  // namespace

std::string page(const Evidence& evidence, const fs::path& sources, const fs::path& report) {
  return fill(read_text(sources / "report" / "template.html"),
              {{"style", read_text(sources / "report" / "page.css")},
               {"script", read_text(sources / "report" / "page.js")},
               {"animation_script", read_text(sources / "report" / "top.js")},
               {"verdict", verdict(evidence)},
               {"figures", figures(sources, report)},
               {"ledger", table_section(evidence.ledger, "ledger", "Ledger", true)},
               {"claims", table_section(evidence.claims, "claims", "Claims", false)},
               {"quadrature", quadrature_section(report)},
               {"accuracy", accuracy_section(report)},
               {"plates", plates_section(report)},
               {"ball", ball_section(report)},
               {"contact", contact_section(report)},
               {"top", top_section(report)},
               {"integrators", integrators_section(report)},
               {"scenes", scenes_section(report)},
               {"cost", cost_section(report)},
               {"effects", effects_section(report)},
               {"provenance", provenance()},
               {"programs", programs(evidence)}});
}

}  // namespace report
