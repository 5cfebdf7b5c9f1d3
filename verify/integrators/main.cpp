// What each integrator does: measured orders in flight, slip, stick and rolling, through impacts and
// accumulations; what becomes of rest, of inelastic impacts, of nutation and energy; and what LG03 says of
// it. Writes integrator_orders.tsv, integrator_errors.tsv, integrator_habits.tsv, integrator_nutation.tsv,
// integrator_paper_top.tsv.
//   verify_integrators [--out FOLDER]

#include "checks.hpp"
#include "common/program.hpp"

namespace verify::integrators {
namespace {

int run(const std::filesystem::path& folder) {
  Record record("integrators");
  Findings found;
  check_orders(folder, record, found);
  check_printed_contact(record, found);
  check_habits(folder, record, found);
  check_paper_top(folder, record, found);
  judge_sentences(record, found);
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::integrators

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::integrators::run); }
