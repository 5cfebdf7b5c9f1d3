// contensou sweep: runs a scene at every point of a grid and writes a row for each.

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bad_input.hpp"
#include "contensou/output/progress.hpp"
#include "contensou/text/name.hpp"
#include "contensou/text/quoted.hpp"
#include "output.hpp"
#include "scene_options.hpp"
#include "signals.hpp"
#include "study.hpp"
#include "subcommand.hpp"
#include "sweep_crew.hpp"
#include "sweep_file.hpp"

namespace cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* description =
    "Study: runs a scene at every point of a grid, on all cores, and writes a row for each.\n\n"
    "Each --vary takes a key of the scene through a range or a list of values; the grid is all combinations, "
    "the last\n"
    "--vary varies fastest. All of its scenes are read before the first is run. Written into one table, a "
    "row "
    "as each\n"
    "run finishes:\n"
    "    run                        its number, from 0\n"
    "    a column each --vary       the value\n"
    "    a column each outcome      of the scene's tables [outcome.NAME]; nan: it has no number here;\n"
    "                               where there is no such table, the last value of each column\n"
    "    status steps wall_seconds  finished, or how the run ended: then its outcomes are nan\n"
    "Killed at any moment, the same command goes on where it was. At the end the rows are put in order, and "
    "but "
    "for\n"
    "wall_seconds the table is the same however many cores there were.\n";

constexpr const char* examples =
    "Examples:\n"
    "  contensou sweep scenes/bouncing_ball.toml --vary contact.table.restitution=0.5:0.9:5\n"
    "  contensou sweep scenes/sidespin.toml --vary contact.cloth.radius=1e-3,4e-3 --vary "
    "contact.cloth.pressure=uniform,hertz\n"
    "  contensou sweep scenes/tippe_top.toml --vary initial.psi_dot=60:240:4 --jobs 1 --quiet --out top.tsv\n"
    "  mpirun -n 4 contensou sweep scenes/sliding_disc.toml --vary body.puck.spin=10:100:1000\n\n"
    "Under MPI, where it was built with it (Debian: libopenmpi-dev), the first process has the file and each "
    "does one run\n"
    "at a time. Ctrl-C lets the runs that were begun finish; a second one does not.";

struct SweepOptions {
  Command command;
  std::vector<std::string> variations;
  std::optional<std::string> out;
  std::optional<std::string> jobs;
  bool quiet = false;
  bool restart = false;

  fs::path file() const {
    return out ? fs::path(*out) : fs::path(fs::path(command.scene).stem().string() + "_sweep.tsv");
  }
};

constexpr unsigned most_jobs = 1024;

/// How many threads: as told, else one for each of the machine's.
unsigned thread_count(const std::optional<std::string>& told) {
  if (!told) return std::clamp(std::thread::hardware_concurrency(), 1u, most_jobs);
  unsigned jobs = 0;
  if (!contensou::parse(*told, jobs) || jobs == 0 || jobs > most_jobs)
    throw BadInput("--jobs: " + contensou::in_quotes(*told) +
                   " is no number of threads; expected a whole number from 1 to " +
                   std::to_string(most_jobs));
  return jobs;
}

std::unique_ptr<SweepCrew> make_crew(const SweepOptions& options) {
  if (!mpi_job().several) return threads_crew(thread_count(options.jobs));
  if (options.jobs)
    throw BadInput("--jobs: " + contensou::in_quotes(*options.jobs) +
                   " is not used under MPI; expected the number of processes in mpirun -n");
  std::unique_ptr<SweepCrew> crew = ranks_crew();
  if (crew == nullptr)
    throw BadInput(
        "started as one of several processes, but built without MPI (Debian: libopenmpi-dev); expected one "
        "process, which uses all cores");
  return crew;
}

/// Reads the scenes of these runs on all cores: what is wrong with the first that is not good; empty:
/// nothing.
std::string first_complaint(const Study& study, const std::vector<std::size_t>& runs) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::size_t first = runs.size();
  std::string what;
  const auto check = [&] {
    for (std::size_t i = next++; i < runs.size(); i = next++) {
      const auto found = complaint(study, runs[i]);
      if (!found) continue;
      const std::lock_guard lock(mutex);
      if (i < first) {
        first = i;
        what = *found;
      }
      return;  // those before it have been begun
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < thread_count({}); ++i) threads.emplace_back(check);
  check();
  for (std::thread& thread : threads) thread.join();
  return what;
}

/// What a process has in hand before the first run.
struct Prepared {
  std::optional<Study> study;
  std::optional<SweepFile> file;  ///< the leader's
  std::vector<std::size_t> runs;  ///< that are left
};

/// Returns what is wrong; empty: nothing. Nothing is written before all is known to be good.
std::string prepare(const SweepOptions& options, bool leads, Prepared& prepared) {
  try {
    prepared.study = make_study(options.command, options.variations);
    if (!leads) return {};
    prepared.file.emplace(options.file(), prepared.study->header, options.restart);
    prepared.runs = prepared.file->missing();
    std::string what = first_complaint(*prepared.study, prepared.runs);
    if (what.empty()) prepared.file->begin();
    return what;
  } catch (const std::exception& error) {
    return error.what();
  }
}

double since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// How far a sweep has come.
struct Tally {
  std::size_t runs = 0, done = 0, now = 0, unfinished = 0;

  void add(const std::string& row) {
    ++done;
    ++now;
    if (row.find("\tfinished\t") == std::string::npos) ++unfinished;
  }
  std::string text() const { return std::to_string(done) + " of " + std::to_string(runs) + " runs"; }
};

/// Computes what is left and returns the signal that ended it early, or 0.
int compute(SweepCrew& crew, const SweepOptions& options, const SignalsHeld& signals, Prepared& prepared,
            Tally& tally) {
  int signal = 0;
  std::optional<contensou::Progress> progress;
  if (crew.leads() && !options.quiet && isatty(STDERR_FILENO) != 0)
    progress.emplace(std::cerr, static_cast<double>(tally.done), static_cast<double>(tally.runs), "",
                     " runs");
  const auto begin = std::chrono::steady_clock::now();
  crew.share({.runs = prepared.runs,
              .compute = [&](std::size_t run) { return row(*prepared.study, run); },
              .take =
                  [&](const std::string& row) {
                    prepared.file->append(row);
                    tally.add(row);
                  },
              .stop =
                  [&] {
                    if (progress) progress->show(static_cast<double>(tally.done), since(begin));
                    if (signal == 0 && (signal = signals.take()) != 0) signals.release();
                    return signal != 0;
                  }});
  return signal;
}

void run(const SweepOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  std::optional<SignalsHeld> signals;
  if (mpi_job().several) signals.emplace();  // in the threads that MPI starts, too
  const std::unique_ptr<SweepCrew> crew = make_crew(options);
  Prepared prepared;
  const std::string complaint = crew->agree(prepare(options, crew->leads(), prepared));
  if (!complaint.empty()) throw BadInput(complaint);

  if (!signals) signals.emplace();
  Tally tally;
  tally.runs = prepared.study->header.runs;
  tally.done = tally.runs - prepared.runs.size();
  const int signal = compute(*crew, options, *signals, prepared, tally);
  if (!crew->leads()) return;

  const std::string place = contensou::printable(options.file().string());
  if (tally.done < tally.runs)
    throw Interrupted(
        "stopped: " + tally.text() + " are in " + place + "; the same command goes on from here", signal);
  prepared.file->finish();
  if (tally.unfinished != 0)
    std::cerr << "contensou sweep: " << tally.unfinished
              << " runs did not reach their end: see the column status; contensou simulate with the run's "
                 "values says why\n";
  if (options.quiet) return;
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3g", since(begin));
  deliver(
      tally.text() + ", " + std::to_string(tally.now) + " of them now in " + seconds + " s: " + place + '\n',
      std::nullopt);
}

}  // namespace

void add_sweep(CLI::App& program) {
  CLI::App* sweep = program.add_subcommand("sweep", description);

  const auto options = std::make_shared<SweepOptions>();
  add_scene_options(*sweep, options->command);
  sweep
      ->add_option("--vary", options->variations,
                   "KEY=A:B:N      N numbers from A to B, both included\n"
                   "KEY=A:B:N:log  the same with even ratios\n"
                   "KEY=V1,V2,...  these values, as for --set; once for each key")
      ->required()
      ->allow_extra_args(false)
      ->option_text("KEY=VALUES");
  sweep
      ->add_option("--out", options->out,
                   "The table to write, instead of one named after the scene\nin the current folder")
      ->option_text("FILE");
  sweep->add_option("--jobs", options->jobs, "How many runs at a time, instead of one on each core")
      ->option_text("N");
  sweep->add_flag("--restart", options->restart,
                  "Overwrite a table that is there, instead of going on with it");
  sweep->add_flag("--quiet", options->quiet, "No progress, no closing line");
  sweep->footer(examples);
  sweep->callback([options] { run(*options); });
}

}  // namespace cli
