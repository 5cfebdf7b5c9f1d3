// Joins what the verification programs left behind and writes the report page.
//
//   contensou_report --report build/report --sources reproduce     writes claims.tsv, ledger.tsv, index.html
//   contensou_report --report build/report --verdict               says whether all came out as it should

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string_view>

#include "contensou/output/table.hpp"
#include "page.hpp"
#include "parts.hpp"

namespace {

namespace fs = std::filesystem;

int write_page(const fs::path& folder, const fs::path& sources) {
  const report::Evidence evidence = report::collect(folder / "data");
  contensou::write_table(evidence.claims, folder / "data" / "claims.tsv");
  contensou::write_table(evidence.ledger, folder / "data" / "ledger.tsv");
  contensou::write_file(report::page(evidence, sources, folder), folder / "index.html");
  return 0;
}

int say_verdict(const fs::path& folder) {
  const report::Evidence evidence = report::collect(folder / "data");
  std::printf("%s\n", report::in_words(evidence).c_str());
  for (const auto& complaint : evidence.complaints) std::printf("%s\n", complaint.text.c_str());
  if (fs::exists(folder / "index.html")) std::printf("The report: %s\n", (folder / "index.html").c_str());
  return evidence.complaints.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const auto is = [&](int i, std::string_view text) { return i < argc && argv[i] == text; };
  try {
    if (argc == 5 && is(1, "--report") && is(3, "--sources")) return write_page(argv[2], argv[4]);
    if (argc == 4 && is(1, "--report") && is(3, "--verdict")) return say_verdict(argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "contensou_report: %s\n", error.what());
    return 1;
  }
  std::fprintf(stderr, "usage: contensou_report --report FOLDER (--sources FOLDER | --verdict)\n");
  return 2;
}
