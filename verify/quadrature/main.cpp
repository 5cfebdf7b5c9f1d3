// verify_quadrature [--out FOLDER]
//
// Coulomb's law on each surface element, LG03 (2.1), integrated over the disc by GSL's adaptive quadrature in
// both coordinate systems of the paper. The library's laws, the paper's series and closed forms, the textbook
// forms in elliptic integrals and the hypergeometric form are each held to it.
#include "checks.hpp"
#include "common/program.hpp"

namespace {

int run(const std::filesystem::path& folder) {
  using namespace verify;
  Record record("quadrature");
  Progress progress(check_laws_steps() + check_forces_steps() + check_radial_steps() + check_printed_steps());
  check_laws(record, folder, progress);
  check_forces(record, folder, progress);
  check_radial(record, folder, progress);
  check_printed(record, progress);
  progress.clear();
  return record.finish(folder / "parts");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, run); }
