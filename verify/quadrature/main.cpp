// verify_quadrature [--out FOLDER]
//
// Coulomb's law on each surface element, LG03 (2.1), integrated over the disc by GSL's adaptive quadrature in
// both coordinate systems of the paper. The library's laws, the paper's series and closed forms, the textbook
// forms in elliptic integrals and the hypergeometric form are each held to it.
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "checks.hpp"

int main(int argc, char** argv) {
  std::filesystem::path folder = "build/report/data";
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--out" && i + 1 < argc) {
      folder = argv[++i];
    } else {
      std::fprintf(stderr, "usage: verify_quadrature [--out FOLDER]   (not understood: %s)\n", argv[i]);
      return 2;
    }
  }
  try {
    using namespace verify;
    Record record("quadrature");
    Progress progress(check_laws_steps() + check_forces_steps() + check_radial_steps() +
                      check_printed_steps());
    check_laws(record, folder, progress);
    check_forces(record, folder, progress);
    check_radial(record, folder, progress);
    check_printed(record, progress);
    progress.clear();
    return record.finish(folder / "parts");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "verify_quadrature: %s\n", error.what());
    return 1;
  }
}
