// The claims ledger: each row of section2.cpp, section3.cpp, friction_ball.cpp, section4.cpp,
// augmented_lagrangian.cpp, section4_2.cpp, section5_system.cpp, section5_data.cpp, section5_stability.cpp,
// appendix_a.cpp and sentences.cpp is computed and judged.   verify_ledger [--out FOLDER]

#include <cstdio>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>

#include "common/program.hpp"
#include "record.hpp"
#include "row.hpp"

namespace verify::ledger {
namespace {

const char* name(Flaw flaw) {
  switch (flaw) {
    case Flaw::misprint:
      return "misprint";
    case Flaw::wrong:
      return "wrong";
    case Flaw::imprecise:
      return "imprecise";
    case Flaw::not_checkable:
      return "not checkable";
    case Flaw::none:
      break;
  }
  return "undecided";  // only where the run fails
}

Claim claim(const Row& row, const std::string& reading, const std::string& what, const Trial& trial,
            double bound, bool should_hold) {
  return {.id = "ledger." + row.id + "." + reading,
          .where = "LG03 " + row.where,
          .claim = what,
          .expected = trial.expected,
          .obtained = trial.obtained,
          .error = trial.error,
          .bound = bound,
          .should_hold = should_hold};
}

/// Computes a row and enters it. The verdict is the numbers': the flaw the row names counts only if the
/// printed form fails and the corrected one passes.
void judge(const Row& row, Record& record) {
  LedgerRow entry{.where = row.where,
                  .printed = row.printed,
                  .verdict = name(row.flaw),
                  .corrected = row.corrected,
                  .evidence = row.reason,
                  .consequence = row.consequence};
  if (row.flaw != Flaw::not_checkable) {
    const Finding found = row.check();
    const bool thought_to_hold = row.flaw == Flaw::none;
    if (found.corrected.has_value() == thought_to_hold)
      throw std::logic_error("ledger: correction missing or idle in " + row.id);
    record.add(claim(row, "printed", row.printed, found.printed, found.bound, thought_to_hold));
    if (found.corrected)
      record.add(claim(row, "corrected", row.corrected, *found.corrected, found.bound, true));
    if (found.printed.error <= found.bound) {
      entry.verdict = "holds";
    } else if (!found.corrected || !(found.corrected->error <= found.bound)) {
      entry.verdict = "undecided";
    }
    entry.evidence = found.evidence;
  }
  record.add(entry);
  std::printf("%-14s %s\n", entry.verdict.c_str(), row.where.c_str());
}

/// Every equation number must have a row of its own.
void require_all_equations(const std::set<std::string>& seen) {
  const auto require = [&](const std::string& section, int last) {
    for (int i = 1; i <= last; ++i) {
      const std::string number = "(" + section + "." + std::to_string(i) + ")";
      if (!seen.contains(number)) throw std::logic_error("ledger: no row for " + number);
    }
  };
  require("2", 21);
  require("3", 22);
  require("4", 20);
  require("5", 37);
  require("A", 5);
}

int run(const std::filesystem::path& folder) {
  Record record("ledger");
  std::set<std::string> places;
  std::set<std::string> ids;
  for (const auto& part :
       {section2(), section3(), friction_ball(), section4(), section4_2(), section5_system(), section5_data(),
        section5_stability(), appendix_a(), sentences()}) {
    for (const Row& row : part) {
      if (!ids.insert(row.id).second) throw std::logic_error("ledger: two rows are called " + row.id);
      places.insert(row.where);
      judge(row, record);
    }
  }
  require_all_equations(places);
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::ledger

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::ledger::run); }
