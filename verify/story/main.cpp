// The story of LG03 5.4 told by the reference solution, what could make the paper's times, the inversion over
// the contact radius and in the limit of Coulomb friction, and how the top ends for any radius and friction.
// Writes event_story.tsv, story_hypotheses.tsv, story_theta.tsv, inversion_over_radius.tsv,
// coulomb_limit.tsv, end_states.tsv.
//   verify_story [--out FOLDER]

#include <filesystem>

#include "checks.hpp"
#include "common/program.hpp"

namespace verify::story {
namespace {

int run(const std::filesystem::path& folder) {
  Record record("story");
  const Told told = tell_events(folder, record);
  const Radii radii = vary_radius(folder, record);
  const Limit limit = take_coulomb_limit(folder, record);
  try_all(folder, record);
  const Weighed weighed = weigh_hypotheses(folder, record);
  enter_ledger(told, weighed, radii, limit, record);
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::story

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::story::run); }
