// What is absent from a scene costs nothing: calls and instructions of short runs, counted by callgrind.
// Fails where an absent effect is paid for, and where a control does not see the code of an effect that is
// there. Writes cost_absent.tsv. verify_absent [--out FOLDER]

#include <algorithm>
#include <cstdio>

#include "common/program.hpp"
#include "contensou/output/table.hpp"
#include "counting.hpp"
#include "record.hpp"

namespace verify::absent {
namespace {

namespace fs = std::filesystem;
using contensou::Table;

constexpr int many = 8;
// One of eight contacts costs an eighth, but for problems whose iterations differ: within a factor of two.
constexpr double slack = 2;

class Judge {
 public:
  Judge() {
    table_.comments = {
        "what is absent from a scene costs nothing: counts by callgrind, of contensou simulate on short "
        "scenes",
        "per step, from the difference of two runs, one twice as long: what reading and writing cost cancels",
        "functions: those that exist for one kind of code alone, by their names in the program;",
        "calls, instructions: of them (without what they call in turn); step_instructions: of the whole step",
        "expected: none (the effect is absent), some (a control: it is there), or the most calls"};
    table_.columns = {"scene",    "method",       "effect_absent",     "functions",
                      "calls",    "instructions", "step_instructions", "steps",
                      "expected", "verdict"};
  }

  /// `most`: calls a step, 0 where the effect is absent; a control has at least some.
  void add(const CountedScene& scene, const StepCosts& costs, const std::string& group, double most,
           bool control) {
    const double calls = costs.calls.at(group), own = costs.own.at(group);
    const bool holds = control    ? calls > 0 && own > 0
                       : most > 0 ? calls > 0 && calls <= most
                                  : calls == 0 && own == 0;
    const std::string expected = control ? "some" : most > 0 ? "at most " + contensou::to_text(most) : "none";
    table_.add({scene.name, scene.method, scene.effect.empty() ? "-" : scene.effect, group, calls, own,
                costs.instructions, costs.steps, expected, holds ? "holds" : "fails"});
    std::printf("  %-22s %-12s %-9s %8.1f calls, %9.0f of %9.0f instructions a step: %s%s\n",
                scene.name.c_str(), scene.method.c_str(), group.c_str(), calls, own, costs.instructions,
                holds ? "as expected, " : "FAILED, expected ", expected.c_str());
    std::fflush(stdout);
    const std::string id = "absent." + scene.name + '.' + scene.method + '.' + group;
    if (control) {
      record_.add(Claim{id, "control",
                        "the count sees " + group + " code where the effect is there (1: calls)", 1,
                        holds ? 1.0 : 0.0, holds ? 0.0 : 1.0, 0});
    } else {
      record_.add(Claim{id, "cost of what is absent",
                        "calls of " + group + " functions a step, " + scene.effect + " being absent", most,
                        calls, holds ? 0 : std::max(calls - most, 1.0), 0});
    }
  }

  void judge(const CountedScene& scene, const StepCosts& costs) {
    for (const std::string& group : scene.absent) add(scene, costs, group, 0, false);
    for (const std::string& group : scene.present) add(scene, costs, group, 0, true);
  }

  int finish(const fs::path& folder) const {
    contensou::write_table(table_, folder / "cost_absent.tsv");
    return record_.finish(folder);
  }

 private:
  Table table_;
  Record record_{"absent"};
};

/// One contact with drilling friction among many without pays for one.
void judge_one_of_many(const std::string& method, const fs::path& folder, Judge& judge) {
  const CountedScene one = balls_on_table(method, many, 1), all = balls_on_table(method, many, many);
  const StepCosts of_one = count_steps(one, folder), of_all = count_steps(all, folder);
  judge.judge(all, of_all);
  for (const std::string& group : all.present) {
    judge.add(one, of_one, group, slack * of_all.calls.at(group) / many, false);
  }
}

int run(const fs::path& folder) {
  const Folder work;
  Judge judge;
  for (const CountedScene& scene : counted_scenes()) judge.judge(scene, count_steps(scene, work.path()));
  for (const char* method : {"moreau", "nscd"}) judge_one_of_many(method, work.path(), judge);
  return judge.finish(folder);
}

}  // namespace
}  // namespace verify::absent

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::absent::run); }
