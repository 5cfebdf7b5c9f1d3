#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace verify {

/// One quantitative claim, judged by a number: a row of claims.tsv.
struct Claim {
  std::string id;       ///< unique and stable, e.g. "uniform.phi.quadrature"
  std::string where;    ///< where the claim stands, e.g. "LG03 (2.8)", "laws.md"
  std::string claim;    ///< one sentence
  double expected = 0;  ///< the value claimed or the oracle's; 0 where only an error is meant
  double obtained = 0;
  double error = 0;         ///< in the measure the bound is in
  double bound = 0;         ///< fixed from analysis before the run
  bool should_hold = true;  ///< false for a claim known to fail, kept to measure by how much
};

/// "holds" if error <= bound, else "fails"; an error or a bound that is not finite always fails. A claim that
/// should not hold and does not is "fails as known"; one that should not hold but does is "holds
/// unexpectedly" (and stops the run as a failure does).
std::string verdict(const Claim& claim);

/// One row of the paper ledger: ledger.tsv.
struct LedgerRow {
  std::string where;        ///< equation number such as "(3.19)", a table, or a sentence with its section
  std::string printed;      ///< what the paper prints (short, plain text or Unicode mathematics)
  std::string verdict;      ///< holds | misprint | wrong | imprecise | not checkable
  std::string corrected;    ///< what should stand there; empty where it holds
  std::string evidence;     ///< numbers that a program of this run reached
  std::string consequence;  ///< what it means for a reader or for this library
};

/// Collects and writes build/report/data/parts/claims-NAME.tsv and ledger-NAME.tsv; the report joins the
/// parts.
class Record {
 public:
  explicit Record(std::string name);
  void add(Claim claim);
  void add(LedgerRow row);
  /// Writes the parts into `folder`, prints a line per failed claim and a summary; returns the program's exit
  /// status: 0 only if every claim came out as it should.
  int finish(const std::filesystem::path& folder) const;

 private:
  std::string name_;
  std::vector<Claim> claims_;
  std::vector<LedgerRow> ledger_;
};

}  // namespace verify
