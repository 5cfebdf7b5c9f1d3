#pragma once

#include <filesystem>
#include <string>

#include "contensou/output/table.hpp"
#include "record.hpp"

namespace verify::answers {

/// A shipped scene's answer beside what the run gave: a row of scenes.tsv and a claim.
struct Answer {
  std::string id;        ///< of the claim, after "scenes."
  std::string scene;     ///< file
  std::string question;  ///< what is measured, with its unit
  std::string source;    ///< of the answer: its formula or what computes it
  double expected = 0;
  double obtained = 0;
  double error = 0;  ///< in the measure of the bound
  double bound = 0;
};

class Sheet {
 public:
  Sheet();
  void add(const Answer& answer);
  /// error |obtained − expected|
  void compare(Answer answer);
  Record& record() { return record_; }
  /// Writes scenes.tsv and the claims; the program's exit status.
  int finish(const std::filesystem::path& folder) const;

 private:
  Record record_;
  contensou::Table table_;
};

}  // namespace verify::answers
