#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "record.hpp"

namespace verify::integrators {

/// What was measured, by name, for the sentences of the paper that speak of it.
using Findings = std::map<std::string, double>;

/// Orders in each phase: integrator_orders.tsv, integrator_errors.tsv. Findings: order.PHASE.SCHEME.
void check_orders(const std::filesystem::path& folder, Record& record, Findings& found);
/// A body dropped, a block pushed, energy: integrator_habits.tsv. Nutation: the same table, and
/// integrator_nutation.tsv over time.
void check_habits(const std::filesystem::path& folder, Record& record, Findings& found);
/// Table 1 and Table 2 in a closed contact, their amplification and their impacts.
void check_printed_contact(Record& record, Findings& found);
/// The paper's top by the schemes the paper speaks of: integrator_paper_top.tsv.
void check_paper_top(const std::filesystem::path& folder, Record& record, Findings& found);
/// The rows of the ledger.
void judge_sentences(Record& record, const Findings& found);

}  // namespace verify::integrators
