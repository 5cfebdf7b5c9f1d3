// What each effect costs that is there: instructions a step of the tippe-top and of a ball on a table, with
// one effect more or less. Writes effect_costs.tsv. bench_effects [--out FOLDER]

#include <cstdio>

#include "common/program.hpp"
#include "contensou/output/file.hpp"
#include "contensou/output/table.hpp"
#include "counting.hpp"

namespace verify::absent {
namespace {

namespace fs = std::filesystem;
using Options = std::vector<std::string>;

struct Variant {
  std::string name;
  int rows;  ///< of the contact
  Options options;
  /// Not from event to event: it cannot, or has hardly a step in so short a time.
  bool by_steps_only = false;
};

Options set(std::initializer_list<std::string> assignments) {
  Options options;
  for (const std::string& assignment : assignments) options.insert(options.end(), {"--set", assignment});
  return options;
}

/// Both contacts of the top get the same law, "law = ..., mu = ...".
Options law(const std::string& law) {
  return {"--unset", "contact.body",
          "--unset", "contact.tip",
          "--set",   "contact.body={" + law + '}',
          "--set",   "contact.tip={" + law + '}'};
}

std::vector<Variant> of_top() {
  const std::string patch = "law=\"contensou\", mu=0.3, radius=5e-4, ";
  return {{"contensou, hertz", 4, law(patch + "pressure=\"hertz\"")},
          {"contensou, uniform", 4, law(patch + "pressure=\"uniform\"")},
          {"contensou, ellipsoid", 4, law(patch + "pressure=\"hertz\", model=\"ellipsoid\"")},
          {"contensou, uncoupled", 4, law(patch + "pressure=\"hertz\", model=\"uncoupled\""), true},
          {"coulomb", 3, law("law=\"coulomb\", mu=0.3")},
          {"frictionless", 1, law("law=\"frictionless\"")},
          {"contensou, hertz, restitution 0.5", 4, law(patch + "pressure=\"hertz\", restitution=0.5")},
          {"contensou, hertz, z_s = 1 m (free flight, both contacts open)", 4, set({"initial.z_s=1"}), true},
          {"the same without gravity", 4, set({"initial.z_s=1", "scene.gravity=0"}), true}};
}

std::vector<Variant> of_ball() {
  const Options drag = set({"body.ball.linear_drag=1e-3", "body.ball.angular_drag=1e-7"});
  return {
      {"contensou, hertz", 4, {}},
      {"with air drag", 4, drag},
      {"with a constant load", 4, set({"load.push={body=\"ball\", force=[0.01, 0, 0]}"})},
      {"with a load that oscillates", 4,
       set({"load.push={body=\"ball\", force=[0.01, 0, 0], frequency=50}"})},
      {"with unequal moments of inertia", 4, set({"body.ball.inertia=[5e-5, 5e-5, 6e-5]"})},
      {"with a radius by the load", 4, set({"contact.ball.radius=hertz", "contact.ball.modulus=1e9"}), true}};
}

class Counts {
 public:
  explicit Counts(fs::path folder) : folder_(std::move(folder)) {
    table_.comments = {
        "what each effect costs: instructions a step, counted by callgrind, of contensou simulate",
        "from the difference of two runs, one twice as long; ratio: to the first of the same scene and "
        "method",
        "rows: of the contact; instructions_per_ms: of simulated time (from event to event, steps differ in "
        "length)"};
    table_.columns = {
        "scene", "method", "variant", "rows", "steps", "step_instructions", "ratio", "instructions_per_ms"};
  }

  void add(const std::string& scene, const std::string& file, const std::string& method, double duration,
           const std::vector<Variant>& variants) {
    double first = 0;
    for (const Variant& variant : variants) {
      Options options = variant.options;
      for (const std::string& option : set({"integrator.method=" + method})) options.push_back(option);
      if (method == "event_driven" && variant.by_steps_only) continue;
      const StepCosts costs = count_steps(file, options, duration, folder_);
      if (first == 0) first = costs.instructions;
      table_.add({scene, method, variant.name, static_cast<double>(variant.rows), costs.steps,
                  costs.instructions, costs.instructions / first,
                  costs.instructions * costs.steps / (1000 * duration)});
      std::printf("  %-10s %-12s %-64s %9.0f instructions a step\n", scene.c_str(), method.c_str(),
                  variant.name.c_str(), costs.instructions);
      std::fflush(stdout);
    }
  }

  const contensou::Table& table() const { return table_; }

 private:
  fs::path folder_;
  contensou::Table table_;
};

int run(const fs::path& folder) {
  const Folder work;
  Counts counts(work.path());
  // Rows of the trajectory are not counted as steps.
  const std::string ball = (work.path() / "ball.toml").string();
  contensou::write_file(ball_with_patch("moreau").text, ball);
  const fs::path top = fs::path(CONTENSOU_SCENES) / "tippe_top.toml";
  for (const char* method : {"moreau", "event_driven"}) {
    counts.add("tippe_top", top.string(), method, 0.02, of_top());
    counts.add("ball", ball, method, 0.02, of_ball());
  }
  contensou::write_table(counts.table(), folder / "effect_costs.tsv");
  return 0;
}

}  // namespace
}  // namespace verify::absent

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::absent::run); }
