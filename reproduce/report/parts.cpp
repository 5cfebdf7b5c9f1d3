#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace report {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

std::vector<fs::path> parts(const fs::path& data, const std::string& kind) {
  std::vector<fs::path> files;
  if (!fs::is_directory(data / "parts")) return files;
  for (const auto& entry : fs::directory_iterator(data / "parts")) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(kind + "-") && name.ends_with(".tsv")) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// All parts of a kind below each other; columns by name, so that a part may have more of them.
Table join(const fs::path& data, const std::string& kind, const std::vector<std::string>& columns) {
  Table all{{}, columns, {}};
  for (const fs::path& file : parts(data, kind)) {
    const Table part = contensou::read_table(file);
    for (const auto& row : part.rows) {
      std::vector<Table::Cell> cells;
      for (const std::string& column : columns) cells.emplace_back(row[part.column(column)]);
      all.add(cells);
    }
  }
  return all;
}

void judge_claims(Evidence& evidence) {
  const auto ids = evidence.claims.texts("id"), verdicts = evidence.claims.texts("verdict");
  std::set<std::string> seen;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!seen.insert(ids[i]).second)
      evidence.complaints.push_back({fmt::format("Two claims are called {}.", ids[i]), ids[i]});
    if (verdicts[i] != "holds" && verdicts[i] != "fails as known") {
      evidence.complaints.push_back({fmt::format("Claim {}: {}.", ids[i], verdicts[i]), ids[i]});
    }
  }
  if (ids.empty()) evidence.complaints.push_back({"No claim was checked.", ""});
}

}  // namespace

Evidence collect(const fs::path& data) {
  Evidence evidence;
  evidence.claims =
      join(data, "claims", {"id", "where", "claim", "expected", "obtained", "error", "bound", "verdict"});
  evidence.claims.comments = {
      "Every claim checked by a program; holds: error <= bound, bounds fixed before the run",
      "command: make reproduce"};
  evidence.ledger =
      join(data, "ledger", {"where", "printed", "verdict", "corrected", "evidence", "consequence"});
  evidence.ledger.comments = {"Every equation and quantitative sentence of LG03, section by section",
                              "command: make reproduce"};
  judge_claims(evidence);
  for (const fs::path& file : parts(data, "status")) {
    const Table table = contensou::read_table(file);
    for (const auto& row : table.rows) {
      evidence.programs.push_back(
          {row[table.column("program")], row[table.column("status")], row[table.column("seconds")]});
      const ProgramStatus& p = evidence.programs.back();
      if (p.status.starts_with("skipped")) {
        evidence.skipped.push_back(fmt::format("{} ({})", p.program, p.status));
      } else if (p.status != "0") {
        evidence.complaints.push_back(
            {fmt::format("Program {} ended with status: {}.", p.program, p.status), ""});
      }
    }
  }
  return evidence;
}

std::string in_words(const Evidence& evidence) {
  auto counts = tally(evidence.claims, "verdict");
  const std::size_t surprises = evidence.complaints.size();
  std::string skipped;
  for (const std::string& program : evidence.skipped) skipped += "; " + program;
  return fmt::format(
      "{} claims hold; {} known to be false fail as they should; "
      "{} surprise{}{}",
      counts["holds"], counts["fails as known"], surprises, surprises == 1 ? "" : "s", skipped);
}

std::map<std::string, int> tally(const Table& table, const std::string& column) {
  std::map<std::string, int> counts;
  for (const std::string& value : table.texts(column)) ++counts[value];
  return counts;
}

}  // namespace report
