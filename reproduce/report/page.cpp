#include "page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "accuracy.hpp"
#include "figures.hpp"
#include "html.hpp"
#include "summaries.hpp"

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

constexpr std::size_t long_table = 20;      // rows; longer ones are folded
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

const std::string not_there =
    "<p class=\"missing\">Not there yet: the program that writes it has not run.</p>\n";

// A table that an older run or a failed program left with other columns or rows must not keep the page from
// being made.
template <class Words>
std::string if_there(const Words& words) {
  try {
    return words();
  } catch (const std::out_of_range& missing) {
    return fmt::format("<p class=\"missing\">Not as expected: {}.</p>\n", escape(missing.what()));
  }
}

// What the table says.
std::string result(const Table& table, const std::string& name) {
  return if_there([&] {
    const std::string sentence = summary(name, table);
    return sentence.empty() ? "" : fmt::format("<p class=\"result\">{}</p>\n", sentence);
  });
}

std::string told(const Table& table, const std::string& name, const std::string& id, const std::string& title,
                 bool open) {
  return result(table, name) + report::table(table, id, title, open);
}

std::string joined(const Table& table, const std::string& id, const std::string& title, bool open) {
  return table.rows.empty() ? not_there : told(table, id, id, title, open);
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
    const std::string stem = file.stem().string();
    if (table.rows.size() > longest_table) {
      html += result(table, stem);
      html += fmt::format("<p class=\"note\">{}: {} rows, in <code>build/report/data/</code>.</p>\n",
                          escape(name), table.rows.size());
    } else {
      html += told(table, stem, "table-" + stem, fmt::format("`{}`", name), table.rows.size() <= long_table);
    }
  }
  return html.empty() ? not_there : html;
}

std::string wide_drawing(const fs::path& file, const std::string& title, const std::string& caption) {
  return fmt::format("<figure><div class=\"panels\"><div class=\"panel wide\">{}</div></div>{}</figure>\n",
                     inline_svg(file, file.stem().string(), title),
                     caption.empty() ? "" : fmt::format("<figcaption><p>{}</p></figcaption>", caption));
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
  for (const fs::path& file : files) html += wide_drawing(file, title, "");
  return html;
}

// The drawing of the errors over u, what to read from it, and the errors by ranges of u.
std::string accuracy(const fs::path& report) {
  const fs::path data = report / "data", drawing = report / "figures" / "accuracy.svg";
  std::string html;
  if (fs::exists(drawing) && fs::exists(data / "accuracy_over_u.tsv") &&
      fs::exists(data / "accuracy_loss.tsv")) {
    html += if_there([&] { return wide_drawing(drawing, "Relative errors over u", accuracy_caption(data)); });
  }
  if (fs::exists(data / "accuracy.tsv")) {
    const Table table = contensou::read_table(data / "accuracy.tsv");
    html += result(table, "accuracy") + if_there([&] { return accuracy_at_a_glance(table); }) +
            report::table(table, "table-accuracy", "`accuracy.tsv`", false);
  }
  return html + tables(report, {"accuracy_"});
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
               {"ledger", joined(evidence.ledger, "ledger", "Ledger", true)},
               {"claims", joined(evidence.claims, "claims", "Claims", false)},
               {"quadrature", tables(report, {"verify_quadrature"})},
               {"accuracy", accuracy(report)},
               {"plates", drawings(report, "plate", "Friction plates") + tables(report, {"plate"})},
               {"cost", drawings(report, "cost_", "Error against time") + tables(report, {"cost_"})},
               {"provenance", provenance()},
               {"programs", programs(evidence)}});
}

}  // namespace report
