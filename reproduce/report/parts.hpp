#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "contensou/output/table.hpp"

/// What the verification programs left behind, joined and judged.
namespace report {

struct ProgramStatus {
  std::string program;
  std::string
      status;  ///< "0" where all went well; another exit status, a signal, "not built", "skipped: why"
  std::string seconds;
};

struct Complaint {
  std::string text;   ///< one sentence
  std::string claim;  ///< the id of the claim it is about, or empty
};

struct Evidence {
  contensou::Table claims;  ///< all parts/claims-*.tsv
  contensou::Table ledger;  ///< all parts/ledger-*.tsv
  std::vector<ProgramStatus> programs;
  std::vector<std::string> skipped;   ///< programs that need something this machine has not, and may
  std::vector<Complaint> complaints;  ///< why the whole is not as it should be; empty where it is
};

/// Reads and joins the parts in `data`/parts. Claims are complained about where one fails, holds
/// unexpectedly, or has the id of another; programs where they did not end with status 0; and it is a
/// complaint if nothing was claimed at all.
Evidence collect(const std::filesystem::path& data);

/// The verdict in one sentence, without a full stop: how many claims hold, how many fail as they should, how
/// many surprises (complaints) there are.
std::string in_words(const Evidence& evidence);

/// How often each value stands in a column.
std::map<std::string, int> tally(const contensou::Table& table, const std::string& column);

}  // namespace report
