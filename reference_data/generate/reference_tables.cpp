// The reference tables reference_data/laws/*.tsv and reference_data/accuracy/*.tsv, from interval arithmetic.
//
//   make_reference_tables FOLDER      writes FOLDER/laws and FOLDER/accuracy; the same bytes each time
//
// Writes nothing at all, and exits with status 1, unless every check of every row held.

#include <flint.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "arguments.hpp"
#include "evaluation.hpp"

namespace {

using reference::Entries;
using reference::Proof;

struct Pressure {
  std::string file;
  std::string title;
  double n;
};

const std::vector<Pressure> pressures = [] {
  std::vector<Pressure> all = {{"uniform", "uniform pressure", 0}, {"hertz", "Hertz pressure", 0.5}};
  for (const char* name : {"-0.99", "-0.9", "-0.5", "-0.25", "0.25", "0.75", "1", "1.5", "2", "3.3", "5",
                           "20", "100", "1000", "1e6"}) {
    double n = 0;
    const std::string text = name;
    std::from_chars(text.data(), text.data() + text.size(), n);
    all.push_back({"power_" + text, "pressure proportional to (1 - rho^2/R^2)^" + text, n});
  }
  return all;
}();

std::string shortest(double x) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

std::string exactly(double x) {
  char text[64];
  const std::string magnitude(
      text, std::to_chars(text, text + sizeof text, std::abs(x), std::chars_format::hex).ptr);
  std::string prefix = x < 0 ? "-0x" : "0x";
  return prefix.append(magnitude);
}

std::string header(const Pressure& pressure, const std::string& about) {
  return "# Coulomb-Contensou friction, " + pressure.title + ": " + about +
         "\n"
         "# n = " +
         shortest(pressure.n) + " (exactly " + exactly(pressure.n) +
         ")\n"
         "# sigma = (n+1) lambda_N/(pi R^2) (1 - rho^2/R^2)^n; Phi after Leine & Glocker (2003), LG03 (2.1)\n"
         "# units: dimensionless\n"
         "# precision: 34 significant digits, each entry correctly rounded (to nearest); proved by interval "
         "arithmetic\n"
         "# u = |v|/(|omega| R): the double itself, shortest decimal that reads back to it; all entries "
         "belong to it exactly\n"
         "# phi = Phi/(mu lambda_N sqrt(v^2 + (omega R)^2)) = f/sqrt(1 + u^2), f(u) = Phi/(mu lambda_N "
         "|omega| R)\n"
         "# xi = |lambda_T|/(mu lambda_N) = f'(u)\n"
         "# eta = |tau_N|/(mu lambda_N R) = f - u f'(u)\n"
         "# f2 = f''(u) for u <= 1, u^3 f''(u) for u > 1 (limit 1/(2(2+n)) at u = inf)\n"
         "# generator: reference_data/generate (FLINT/Arb)\n"
         "# command: cmake --build build --target reference_tables\n";
}

std::string row(double u, const Entries& entries) {
  std::string line = shortest(u);
  for (const std::string& entry : entries) line += '\t' + entry;
  return line + '\n';
}

/// The chord integrals for every row; the rings, which are slow and need n >= 0, for a few.
std::string law_table(const Pressure& pressure, Proof& proof) {
  std::string text = header(pressure, "phi, xi, eta, f'' over u") + "u\tphi\txi\teta\tf2\n";
  const std::vector<double> ring_checks = {0.1, 0.75, 1, 1.25};
  Entries last;
  for (const double u : reference::law_arguments()) {
    if (std::isinf(u)) {
      // At the largest double f'' has its limit to six hundred digits.
      const Entries limit = reference::at_infinity(pressure.n);
      if (limit.back() != last.back()) throw std::runtime_error("the limit of u^3 f'' is not 1/(2(2+n))");
      text += row(u, limit);
      continue;
    }
    bool rings = false;
    for (const double chosen : ring_checks) rings = rings || (u == chosen && pressure.n >= 0);
    last = evaluate(pressure.n, u, {.chords = true, .rings = rings}, proof);
    text += row(u, last);
  }
  return text;
}

std::string accuracy_table(const Pressure& pressure, Proof& proof) {
  std::string text = header(pressure, "pseudo-random u in named ranges");
  const std::vector<reference::Range> ranges = reference::accuracy_ranges();
  text += "# range:";
  for (const auto& range : ranges) text += ' ' + range.name + ' ' + range.interval;
  text += "\nrange\tu\tphi\txi\teta\tf2\n";
  constexpr std::size_t every = 10;  // the closed forms check every row
  for (const auto& range : ranges) {
    for (std::size_t i = 0; i < range.u.size(); ++i) {
      const bool chords = i % every == 0;
      text += range.name + '\t' + row(range.u[i], evaluate(pressure.n, range.u[i], {chords, false}, proof));
    }
  }
  return text;
}

void say(const std::string& name, const Proof& p) {
  std::printf("%-24s %5d rows, 2F1 < 2^%.0f (%ld bits)", name.c_str(), p.rows, p.widest_stored, p.most_bits);
  if (p.closed > 0) std::printf("; closed form %d rows < 2^%.0f", p.closed, p.widest_closed);
  if (p.chords > 0) std::printf("; chords %d rows < 2^%.0f", p.chords, p.widest_chord);
  if (p.rings > 0) std::printf("; rings %d rows < 2^%.0f", p.rings, p.widest_ring);
  std::printf("\n");
  std::fflush(stdout);
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path.string());
}

struct Job {
  std::string file;
  std::function<std::string(Proof&)> table;
  std::string text = {};
};

std::vector<Job> all_tables() {
  std::vector<Job> jobs;
  for (const Pressure& pressure : pressures) {
    jobs.push_back(
        {"laws/" + pressure.file + ".tsv", [&pressure](Proof& proof) { return law_table(pressure, proof); }});
  }
  for (const Pressure& pressure : {std::cref(pressures[0]), std::cref(pressures[1])}) {
    jobs.push_back({"accuracy/" + pressure.file + ".tsv",
                    [&pressure](Proof& proof) { return accuracy_table(pressure, proof); }});
  }
  return jobs;
}

/// The tables share nothing, so that each comes out the same whichever thread makes it and whenever.
void run(const std::filesystem::path& folder) {
  std::vector<Job> jobs = all_tables();
  std::atomic<std::size_t> next = 0;
  std::mutex report;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      Job& job = jobs[i];
      Proof proof;
      try {
        job.text = job.table(proof);
        const std::lock_guard lock(report);
        say(job.file, proof);
      } catch (...) {
        const std::lock_guard lock(report);
        failure = std::current_exception();
        next = jobs.size();
      }
    }
    flint_cleanup();
  };
  {
    std::vector<std::jthread> threads(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
    for (auto& thread : threads) thread = std::jthread(work);
  }
  if (failure) std::rethrow_exception(failure);
  for (const Job& job : jobs) write(folder / job.file, job.text);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_reference_tables FOLDER\n");
    return 2;
  }
  int status = 0;
  try {
    run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "nothing written: %s\n", error.what());
    status = 1;
  }
  return status;
}
