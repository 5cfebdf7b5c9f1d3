// LG03 5.5 against the whole nonlinear top in its slipping contact: (5.22) to (5.37), the regions of Fig. 11,
// rates of growth over the contact radius, and what the drilling torque does that (5.22) leaves out. Writes
// stability_growth.tsv, fig11_simulated.tsv.   verify_stability [--out FOLDER]

#include <filesystem>

#include "checks.hpp"
#include "common/program.hpp"

namespace verify::stability {
namespace {

int run(const std::filesystem::path& folder) {
  Record record("stability");
  check_equations(record);
  check_regions(record);
  check_growth(folder, record);
  check_points(folder, record);
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::stability

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::stability::run); }
