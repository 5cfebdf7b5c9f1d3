#include "counting.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "contensou/output/file.hpp"
#include "contensou/text/number.hpp"

namespace verify::absent {
namespace {

namespace fs = std::filesystem;

/// A number of summary.json.
double summary_number(const fs::path& file, const std::string& key) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t at = text.find('"' + key + "\": ");
  if (at == std::string::npos) throw std::runtime_error(file.string() + ": has no " + key);
  return std::strtod(text.c_str() + at + key.size() + 4, nullptr);
}

struct Run {
  Profile profile;
  double steps;
};

Run run(const std::string& scene, const std::vector<std::string>& options, double duration,
        const fs::path& folder) {
  const fs::path out = folder / "run";
  std::vector<std::string> command{CONTENSOU_PROGRAM, "simulate", scene, "--quiet", "--out", out.string()};
  for (const std::string& option : options) command.push_back(option);
  command.insert(command.end(), {"--set", "scene.duration=" + contensou::to_text(duration)});
  Profile counted = profile(command, folder);
  return {std::move(counted), summary_number(out / "summary.json", "steps")};
}

}  // namespace

StepCosts count_steps(const std::string& scene_file, const std::vector<std::string>& options, double duration,
                      const fs::path& folder) {
  const Run one = run(scene_file, options, duration, folder);
  const Run two = run(scene_file, options, 2 * duration, folder);
  StepCosts costs;
  costs.steps = two.steps - one.steps;
  if (!(costs.steps > 0)) throw std::runtime_error(scene_file + ": the longer run has no more steps");
  costs.instructions = static_cast<double>(two.profile.instructions - one.profile.instructions) / costs.steps;
  for (const CodeGroup& group : code_groups()) {
    const FunctionCount a = count(one.profile, group), b = count(two.profile, group);
    costs.calls[group.name] = static_cast<double>(b.calls - a.calls) / costs.steps;
    costs.own[group.name] = static_cast<double>(b.instructions - a.instructions) / costs.steps;
  }
  return costs;
}

StepCosts count_steps(const CountedScene& scene, const fs::path& folder) {
  const fs::path file = folder / (scene.name + ".toml");
  contensou::write_file(scene.text, file);
  return count_steps(file.string(), {}, scene.duration, folder);
}

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "contensou-count-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": cannot be made");
  path_ = name;
}

Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace verify::absent
