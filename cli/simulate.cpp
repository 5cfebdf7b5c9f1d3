// contensou simulate: runs a scene and writes what came of it into a folder.

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "bad_input.hpp"
#include "contensou/output/progress.hpp"
#include "contensou/scene/run.hpp"
#include "contensou/text/number.hpp"
#include "contensou/text/quoted.hpp"
#include "output.hpp"
#include "output_folder.hpp"
#include "scene_options.hpp"
#include "subcommand.hpp"
#include "summary.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* description =
    "Simulation: runs a scene and writes its motion, its events and its energy ledger.\n\n"
    "A scene is a TOML file that says what is there, how it starts, and how it is to be integrated; see "
    "scenes/.\n"
    "Written into a folder, each file all or nothing:\n"
    "    trajectory.tsv   t theta z_s gap_body gap_tip energy omega_z ...   one row each output.interval\n"
    "    events.tsv       t event contact     event: close, open, accumulation (of impacts), stick, slip;\n"
    "                                        spin: that of a slipping contact changes its sign\n"
    "    summary.json     method and settings, status, steps, wall_seconds, evaluations, energy at both "
    "ends,\n"
    "                     what each contact dissipated by which effect, and what the balance lacks\n"
    "[m], [s], [rad], [J]; theta is the inclination, z_s the height of the centre of mass, a gap the "
    "distance "
    "of a\n"
    "contact from the floor, omega the angular velocity and axis the axis of symmetry in the floor's axes.\n";

constexpr const char* examples =
    "Methods:\n"
    "  event_driven      adaptive, high order, every event located: the reference (tolerance)\n"
    "  rk4               fourth order, events located (step)\n"
    "  moreau            time-stepping, second order in smooth phases (step)\n"
    "  moreau_adaptive   the same with automatic step size (tolerance)\n"
    "  moreau_implicit   fully implicit time-stepping, first order (step)\n"
    "  moreau_printed, rk4_printed   Tables 1 and 2 of LG03 to the letter (step)\n\n"
    "Examples:\n"
    "  contensou simulate scenes/tippe_top.toml\n"
    "  contensou simulate scenes/tippe_top.toml --set integrator.method=moreau --set integrator.step=1e-4 "
    "--out moreau\n"
    "  contensou simulate scenes/tippe_top.toml --set contact.body.radius=1e-4 --quiet --out small_radius\n\n"
    "Every key of the scene must be known and used, with one exception: step and tolerance may both stand, "
    "and\n"
    "summary.json says which was used. Exit status 1 where a run does not reach its end (a solver failed, a "
    "scheme\n"
    "became unstable): then what there is is written, and summary.json says how far it came.";

struct SimulateOptions {
  Command command;
  std::optional<std::string> out;
  bool quiet = false;
};

contensou::Outcome run_with_progress(contensou::Simulation& simulation, bool quiet) {
  if (quiet || isatty(STDERR_FILENO) == 0) return contensou::run(simulation);
  contensou::Progress progress(std::cerr, simulation.state.t, simulation.t_end);
  const auto begin = std::chrono::steady_clock::now();
  return contensou::run(simulation, [&](double t) {
    progress.show(t, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  });
}

/// What a scene asks for and only the method or the system sees that it cannot be is bad input, too.
contensou::Outcome compose_and_run(const contensou::Scene& scene, bool quiet) {
  try {
    contensou::Simulation simulation = compose(scene);
    return run_with_progress(simulation, quiet);
  } catch (const std::invalid_argument& error) {
    throw BadInput(scene.file + ": " + contensou::printable(error.what()));
  }
}

void write(const fs::path& folder, const Command& command, const contensou::Scene& scene,
           const contensou::Outcome& outcome) {
  const std::string made_by = "# contensou simulate " + contensou::printable(command.scene) + ", method " +
                              name(scene.integrator.method) +
                              ", version " CONTENSOU_VERSION "; see summary.json\n";
  const std::string trajectory = made_by +
                                 "# units: s, rad, m, J, rad/s; vectors in the floor's axes, z up\n" +
                                 trajectory_table(outcome);
  const std::string events = made_by + "# units: s\n" + events_table(outcome);
  const std::string json = summary(command, scene, outcome);
  write_together({{folder / "trajectory.tsv", trajectory},
                  {folder / "events.tsv", events},
                  {folder / "summary.json", json}});
}

void run(const SimulateOptions& options) {
  const Command& command = options.command;
  const contensou::Scene scene = changed_scene(command);
  const fs::path folder = options.out ? fs::path(*options.out) : fs::path(command.scene).stem();
  require_writable(folder);

  const contensou::Outcome outcome = compose_and_run(scene, options.quiet);
  write(folder, command, scene, outcome);

  const contensou::RunReport& report = outcome.report;
  const std::string place = contensou::printable(folder.string());
  if (report.status != contensou::RunStatus::finished) {
    throw std::runtime_error(std::string(name(report.status)) + " at t = " + contensou::to_text(outcome.t) +
                             " of " + contensou::to_text(scene.duration) + " s" +
                             (report.message.empty() ? "" : ": " + report.message) +
                             "; what was computed is in " + place);
  }
  if (!report.message.empty())
    std::cerr << "contensou simulate: " << contensou::printable(report.message) << '\n';
  if (options.quiet) return;
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3g", outcome.wall_seconds);
  deliver(contensou::to_text(outcome.t) + " s of motion in " + seconds +
              " s: trajectory.tsv, events.tsv, summary.json in " + place + '\n',
          std::nullopt);
}

}  // namespace

void add_simulate(CLI::App& program) {
  CLI::App* simulate = program.add_subcommand("simulate", description);

  const auto options = std::make_shared<SimulateOptions>();
  add_scene_options(*simulate, options->command);
  simulate
      ->add_option("--out", options->out,
                   "The folder to write into, instead of one named after the\nscene in the current folder")
      ->option_text("DIR");
  simulate->add_flag("--quiet", options->quiet, "No progress, no closing line");
  std::string keys = "Keys of a scene:\n";
  std::istringstream lines(contensou::scene_help());
  for (std::string line; std::getline(lines, line);) keys += "  " + line + '\n';
  simulate->footer(keys + '\n' + examples);
  simulate->callback([options] { run(*options); });
}

}  // namespace cli
