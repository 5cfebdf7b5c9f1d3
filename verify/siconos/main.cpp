// Our contact solver and friction ball against somebody else's: Siconos. Without contact radius the same
// problems, with one the patch cut into points. Writes siconos_coulomb.tsv, siconos_patch.tsv,
// siconos_ball.tsv. verify_siconos [--out FOLDER]

#include <cstdio>
#include <filesystem>

#include "common/program.hpp"
#include "coulomb.hpp"
#include "patch_study.hpp"
#include "record.hpp"

namespace {

int run(const std::filesystem::path& folder) {
  verify::Record record("siconos");
  std::printf("the ball of N points\n");
  verify::siconos::check_ball(record, folder);
  std::printf("the patch cut into N points, solved by Siconos\n");
  verify::siconos::check_patch(record, folder);
  std::printf("Coulomb contacts\n");
  verify::siconos::check_coulomb(record, folder);
  return record.finish(folder / "parts");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, run); }
