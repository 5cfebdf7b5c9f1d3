#include "record.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

#include "contensou/output/table.hpp"

namespace verify {

std::string verdict(const Claim& claim) {
  // What is no number measures nothing, not even a flaw that is known; an infinite bound bounds nothing.
  if (!std::isfinite(claim.error) || !std::isfinite(claim.bound)) return "fails";
  const bool holds = claim.error <= claim.bound;
  if (claim.should_hold) return holds ? "holds" : "fails";
  return holds ? "holds unexpectedly" : "fails as known";
}

Record::Record(std::string name) : name_(std::move(name)) {}

void Record::add(Claim claim) { claims_.push_back(std::move(claim)); }
void Record::add(LedgerRow row) { ledger_.push_back(std::move(row)); }

int Record::finish(const std::filesystem::path& folder) const {
  contensou::Table claims{
      {}, {"id", "where", "claim", "expected", "obtained", "error", "bound", "verdict"}, {}};
  int surprises = 0;
  for (const Claim& c : claims_) {
    const std::string v = verdict(c);
    claims.add({c.id, c.where, c.claim, c.expected, c.obtained, c.error, c.bound, v});
    if (v == "fails" || v == "holds unexpectedly") {
      ++surprises;
      std::printf("%s: %s: error %.3g, bound %.3g\n", v.c_str(), c.id.c_str(), c.error, c.bound);
    }
  }
  contensou::Table ledger{{}, {"where", "printed", "verdict", "corrected", "evidence", "consequence"}, {}};
  for (const LedgerRow& r : ledger_) {
    ledger.add({r.where, r.printed, r.verdict, r.corrected, r.evidence, r.consequence});
  }
  if (!claims.rows.empty()) contensou::write_table(claims, folder / ("claims-" + name_ + ".tsv"));
  if (!ledger.rows.empty()) contensou::write_table(ledger, folder / ("ledger-" + name_ + ".tsv"));
  std::printf("%s: %zu claims, %d not as they should be; %zu ledger rows\n", name_.c_str(), claims_.size(),
              surprises, ledger_.size());
  return surprises == 0 ? 0 : 1;
}

}  // namespace verify
