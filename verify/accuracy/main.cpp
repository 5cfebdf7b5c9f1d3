// verify_accuracy [--out FOLDER] [--reference FOLDER]
// The accuracy of the library's laws in ulp beside the ways other people compute them, and where those lose
// their digits.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string_view>

#include "loss.hpp"
#include "power_law.hpp"
#include "record.hpp"
#include "ulp_table.hpp"

int main(int argc, char** argv) {
  std::filesystem::path data = "build/report/data";
  std::filesystem::path reference = CONTENSOU_REFERENCE_DATA;
  for (int i = 1; i < argc; i += 2) {
    const std::string_view option = argv[i];
    if (i + 1 < argc && option == "--out") {
      data = argv[i + 1];
    } else if (i + 1 < argc && option == "--reference") {
      reference = argv[i + 1];
    } else {
      std::fprintf(stderr, "usage: verify_accuracy [--out FOLDER] [--reference FOLDER]\n");
      return 2;
    }
  }
  try {
    verify::Record record("accuracy");
    std::printf("accuracy in ulp\n");
    accuracy::measure_ulp(reference, data, record);
    std::printf("where formulas lose their digits\n");
    accuracy::measure_loss(reference, data, record);
    std::printf("general exponents\n");
    accuracy::measure_power_law(reference, data, record);
    return record.finish(data / "parts");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "verify_accuracy: %s\n", error.what());
    return 1;
  }
}
