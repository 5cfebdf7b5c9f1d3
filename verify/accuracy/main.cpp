// verify_accuracy [--out FOLDER]
// The accuracy of the library's laws in ulp beside the ways
// other people compute them, and where those lose their digits.

#include <cstdio>

#include "common/program.hpp"
#include "loss.hpp"
#include "over_u.hpp"
#include "power_law.hpp"
#include "record.hpp"
#include "ulp_table.hpp"

namespace {

int run(const std::filesystem::path& folder) {
  const std::filesystem::path reference = CONTENSOU_REFERENCE_DATA;
  verify::Record record("accuracy");
  std::printf("accuracy in ulp\n");
  accuracy::measure_ulp(reference, folder, record);
  std::printf("where formulas lose their digits\n");
  accuracy::measure_loss(reference, folder, record);
  accuracy::tabulate_over_u(reference, folder);
  std::printf("general exponents\n");
  accuracy::measure_power_law(reference, folder, record);
  return record.finish(folder / "parts");
}

}  // namespace

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, run); }
