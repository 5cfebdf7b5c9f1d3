#include "study.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>

#include "bad_input.hpp"
#include "contensou/scene/outcome.hpp"
#include "contensou/scene/run.hpp"
#include "contensou/text/number.hpp"
#include "contensou/text/quoted.hpp"

namespace cli {
namespace {

using contensou::MeasureScene;
using contensou::printable;
using contensou::Scene;

constexpr const char* first_column = "run";
constexpr const char* last_columns[] = {"status", "steps", "wall_seconds"};

/// 64 bits of FNV-1a over texts, each with its length, so that none can pass for two.
class Fingerprint {
 public:
  void add(const std::string& text) {
    add_bytes(std::to_string(text.size()) + ' ');
    add_bytes(text);
  }
  std::string text() const {
    char buffer[17];
    std::snprintf(buffer, sizeof buffer, "%016llx", static_cast<unsigned long long>(hash_));
    return buffer;
  }

 private:
  void add_bytes(const std::string& bytes) {
    for (const char byte : bytes) hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  }
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// All that the numbers of a sweep depend on.
std::string fingerprint(const Command& command, const contensou::Grid& grid) {
  Fingerprint print;
  print.add(CONTENSOU_VERSION);
  std::ifstream in(command.scene, std::ios::binary);
  print.add({std::istreambuf_iterator<char>(in), {}});
  for (const std::string& key : command.unset) print.add("--unset " + key);
  for (const std::string& assignment : command.set) print.add("--set " + assignment);
  for (const contensou::GridAxis& axis : grid.axes) {
    print.add("--vary " + axis.key);
    for (const std::string& value : axis.values) print.add(value);
  }
  return print.text();
}

/// The command as far as the numbers depend on it.
std::string made_by(const Command& command, const std::vector<std::string>& variations) {
  std::string text = "contensou sweep " + printable(command.scene);
  for (const std::string& key : command.unset) text += " --unset " + printable(key);
  for (const std::string& assignment : command.set) text += " --set '" + printable(assignment) + '\'';
  for (const std::string& variation : variations) text += " --vary '" + printable(variation) + '\'';
  return text + ", version " CONTENSOU_VERSION;
}

/// The scene's outcomes; where it names none, the last values of all columns.
std::vector<MeasureScene> measures(const Scene& scene) {
  return scene.measures.empty() ? contensou::last_values(scene) : scene.measures;
}

std::vector<std::string> names(const std::vector<MeasureScene>& measures) {
  std::vector<std::string> names;
  for (const MeasureScene& measure : measures) names.push_back(measure.name);
  return names;
}

void require_other_names(const std::string& scene, const std::vector<std::string>& outcomes) {
  for (const std::string& outcome : outcomes) {
    bool taken = outcome == first_column;
    for (const char* column : last_columns) taken = taken || outcome == column;
    if (taken)
      throw BadInput(scene + ": outcome." + outcome +
                     ": a sweep has a column of this name; expected another name");
  }
}

/// The scene of a run. Throws BadInput in one line that names the run.
Scene scene_of(const Study& study, std::size_t run) {
  try {
    return contensou::read_scene(contensou::at(study.grid, run, study.document));
  } catch (const std::invalid_argument& error) {
    std::string what = error.what();
    for (const contensou::GridAxis& axis : study.grid.axes) {
      const std::string set = "--set " + axis.key;
      if (what.starts_with(set)) what.replace(0, set.size(), "--vary " + axis.key);
    }
    throw BadInput(contensou::describe(study.grid, run) + ": " + what);
  }
}

std::vector<double> evaluated(const Scene& scene, const contensou::Outcome& outcome) {
  std::vector<double> numbers;
  for (const MeasureScene& measure : measures(scene))
    numbers.push_back(contensou::evaluate(measure, outcome));
  return numbers;
}

}  // namespace

Study make_study(const Command& command, const std::vector<std::string>& variations) {
  Study study;
  try {
    std::vector<contensou::GridAxis> parsed;
    for (const std::string& variation : variations) parsed.push_back(contensou::parse_axis(variation));
    study.grid = contensou::make_grid(std::move(parsed));
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
  study.document = changed_document(command);
  study.outcomes = names(measures(scene_of(study, 0)));
  require_other_names(study.document.file, study.outcomes);

  SweepHeader& header = study.header;
  header.comments = {
      made_by(command, variations),
      "units: SI; outcomes that there are not are nan; wall_seconds differs each time, all else is the same"};
  header.fingerprint = fingerprint(command, study.grid);
  header.columns = {first_column};
  for (const contensou::GridAxis& axis : study.grid.axes) header.columns.push_back(axis.key);
  header.columns.insert(header.columns.end(), study.outcomes.begin(), study.outcomes.end());
  header.columns.insert(header.columns.end(), std::begin(last_columns), std::end(last_columns));
  header.runs = study.grid.size();
  return study;
}

std::optional<std::string> complaint(const Study& study, std::size_t run) {
  const auto of_run = [&](const std::string& what) {
    return contensou::describe(study.grid, run) + ": " + what;
  };
  try {
    const Scene scene = scene_of(study, run);
    contensou::compose(scene);
    if (names(measures(scene)) == study.outcomes) return {};
    return of_run("has other outcomes than run 0; expected the same");
  } catch (const BadInput& error) {
    return error.what();
  } catch (const std::exception& error) {
    return of_run(printable(error.what()));
  }
}

std::string row(const Study& study, std::size_t run) {
  std::string status = "error", steps = "0", seconds = "0";
  std::vector<double> numbers(study.outcomes.size(), std::numeric_limits<double>::quiet_NaN());
  try {
    const Scene scene = scene_of(study, run);
    contensou::Simulation simulation = contensou::compose(scene);
    const contensou::Outcome outcome = contensou::run(simulation);
    steps = std::to_string(outcome.report.steps);
    seconds = contensou::to_text(outcome.wall_seconds);
    if (outcome.report.status == contensou::RunStatus::finished) numbers = evaluated(scene, outcome);
    status = name(outcome.report.status);
  } catch (const std::exception&) {
    // The row says so; the sweep goes on.
  }
  std::string row = std::to_string(run);
  for (const std::string& value : study.grid.values(run)) row += '\t' + printable(value);
  for (const double number : numbers) row += '\t' + (std::isnan(number) ? "nan" : contensou::to_text(number));
  return row + '\t' + status + '\t' + steps + '\t' + seconds;
}

}  // namespace cli
