#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "figures.hpp"
#include "html.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

constexpr std::size_t long_table = 400;     // rows; longer ones are folded
constexpr std::size_t longest_table = 800;  // rows; longer ones stay in data/

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
  std::string html =
      fmt::format("<div class=\"verdict {}\"><p class=\"sentence\">{}</p>\n", good ? "good" : "bad",
                  good ? "Every claim that should hold holds." : "Not everything came out as it should.");
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
    table.add({p.program, p.status == "0" ? "ok" : "failed: " + p.status, p.seconds});
  return report::table(table, "programs", "Programs of this run", true);
}

std::string joined(const Table& table, const std::string& id, const std::string& title) {
  if (table.rows.empty())
    return "<p class=\"missing\">Not there yet: the program that writes it has not run.</p>\n";
  return report::table(table, id, title, true);
}

// Every table of data/ whose name begins with one of the
// prefixes, as "accuracy" for accuracy.tsv, accuracy_power.tsv.
std::string tables(const fs::path& report, const std::vector<std::string>& prefixes) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(report / "data")) {
    const std::string name = entry.path().filename().string();
    const auto begins = [&name](const std::string& prefix) { return name.starts_with(prefix); };
    if (entry.path().extension() == ".tsv" && std::any_of(prefixes.begin(), prefixes.end(), begins)) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  std::string html;
  for (const fs::path& file : files) {
    const Table table = contensou::read_table(file);
    const std::string name = file.filename().string();
    if (table.rows.size() > longest_table) {
      html += fmt::format("<p class=\"note\">{}: {} rows, in <code>build/report/data/</code>.</p>\n",
                          escape(name), table.rows.size());
    } else {
      html += report::table(table, fmt::format("table-{}", file.stem().string()), fmt::format("`{}`", name),
                            table.rows.size() <= long_table);
    }
  }
  if (html.empty())
    html = "<p class=\"missing\">Not there yet: the program that writes it has not run.</p>\n";
  return html;
}

// Drawings that belong to tables, not to figures of the paper.
std::string drawings(const fs::path& report, const std::string& prefix, const std::string& title) {
  std::vector<fs::path> files;
  if (fs::is_directory(report / "figures")) {
    for (const auto& entry : fs::directory_iterator(report / "figures")) {
      if (entry.path().filename().string().starts_with(prefix) && entry.path().extension() == ".svg") {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  std::string html;
  for (const fs::path& file : files) {
    html += fmt::format("<figure><div class=\"panels\"><div class=\"panel wide\">{}</div></div></figure>\n",
                        inline_svg(file, file.stem().string(), title));
  }
  return html;
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
               {"verdict", verdict(evidence)},
               {"figures", figures(sources, report)},
               {"ledger", joined(evidence.ledger, "ledger", "Ledger")},
               {"claims", joined(evidence.claims, "claims", "Claims")},
               {"quadrature", tables(report, {"verify_quadrature"})},
               {"accuracy", drawings(report, "accuracy", "Accuracy") + tables(report, {"accuracy"})},
               {"plates", drawings(report, "plate", "Friction plates") + tables(report, {"plate"})},
               {"cost", drawings(report, "cost_", "Error against time") + tables(report, {"cost_"})},
               {"programs", programs(evidence)}});
}

}  // namespace report
