// What many bodies cost: balls dropping into a box, time and memory per step over their number.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "common/program.hpp"
#include "contensou/granular/nscd.hpp"
#include "contensou/output/table.hpp"
#include "contensou/system/body_layout.hpp"

namespace bench {
namespace {

using namespace contensou;

constexpr double radius = 0.01;   // [m]
constexpr double density = 2500;  // [kg/m³]
constexpr double step = 1e-3;     // [s]
constexpr double tolerance = 1e-6;
constexpr int layers = 5;
constexpr int steps = 40;

/// n balls in `layers` layers over a square floor between four walls, with random places and velocities.
BodiesData box(int n) {
  BodiesData data;
  data.gravity = {0, 0, -9.81};
  data.rules.push_back({"touch", FrictionDisk{}, 0.3, 0, 0.2});
  data.rule.resize(2, 2);
  data.rule << 0, 0, 0, BodiesData::no_rule;
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(n / static_cast<double>(layers)))));
  const double pitch = 2.2 * radius;
  const double wall = side * pitch;
  std::mt19937_64 g(2003);
  const auto random = [&] { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; };
  const double mass = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  for (int i = 0; i < n; ++i) {
    BodyData ball;
    ball.name = "ball" + std::to_string(i);
    ball.rotation = Rotation::free;
    ball.mass = mass;
    ball.inertia.setConstant(0.4 * mass * radius * radius);
    ball.spheres.push_back({ball.name, Eigen::Vector3d::Zero(), radius, 0});
    ball.position = {(i % side + 0.5) * pitch + 0.05 * radius * random(),
                     (i / side % side + 0.5) * pitch + 0.05 * radius * random(),
                     1.1 * radius + i / (side * side) * pitch};
    ball.velocity = {0.1 * random(), 0.1 * random(), -0.3 + 0.1 * random()};
    data.bodies.push_back(ball);
  }
  data.planes = {{"floor", {0, 0, 1}, 0, 1},
                 {"west", {1, 0, 0}, 0, 1},
                 {"east", {-1, 0, 0}, -wall, 1},
                 {"south", {0, 1, 0}, 0, 1},
                 {"north", {0, -1, 0}, -wall, 1}};
  return data;
}

/// The most memory this process has had so far [bytes].
double peak_memory() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word) {
    if (word == "VmHWM:") status >> kilobytes;
  }
  return 1024 * kilobytes;
}

struct Cost {
  RunReport report;
  NscdCounts counts;
  double seconds = 0;
  double bytes = 0;
};

Cost measure(int n, int threads) {
  const BodiesData data = box(n);
  const BodyLayout layout(data);
  State state = layout.start();
  IntegratorOptions options;
  options.step = step;
  options.solver_tolerance = tolerance;
  const double before = peak_memory();
  Cost cost;
  const auto start = std::chrono::steady_clock::now();
  cost.report = run_nscd(data, state, steps * step, options, threads, {}, &cost.counts);
  cost.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  cost.bytes = peak_memory() - before;
  return cost;
}

/// The slope of ln y over ln x by least squares, where x >= from.
double exponent(const std::vector<double>& x, const std::vector<double>& y, double from) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < from) continue;
    const double a = std::log(x[i]), b = std::log(y[i]);
    n += 1, sx += a, sy += b, sxx += a * a, sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

int run(const std::filesystem::path& folder) {
  Table table{
      {"Balls dropping into a box: " + std::to_string(layers) +
           " layers over a floor as wide as they need, Coulomb friction 0.3, restitution 0.2, steps "
           "of 1e-3 s,",
       "solver tolerance 1e-6; the first 0.04 s, in which they land. All per step but bytes_per_body: "
       "peak memory of the run, less what there was before",
       "(zero where smaller runs had as much). unsolved: part of the steps whose inclusion did not "
       "reach the tolerance"},
      {"bodies", "threads", "seconds", "sweeps", "contacts", "pairs", "seconds_per_body", "bytes_per_body",
       "unsolved", "worst_residual", "deepest"},
      {}};
  std::vector<double> sizes, times;
  double one = 0;
  for (const int n : {1, 3, 10, 30, 100, 300, 1000, 2000}) {
    for (const int threads : {1, 2}) {
      if (threads == 2 && n < 2000) continue;
      const Cost cost = measure(n, threads);
      if (cost.report.status != RunStatus::finished) throw std::runtime_error("bench_bodies: a run failed");
      const auto count = static_cast<double>(cost.report.steps);
      const double seconds = cost.seconds / count;
      const double problems = std::max<double>(1, static_cast<double>(cost.report.contact_problems));
      table.add({static_cast<double>(n), static_cast<double>(threads), seconds,
                 static_cast<double>(cost.report.contact_iterations) / problems,
                 static_cast<double>(cost.counts.contacts) / count,
                 static_cast<double>(cost.counts.pairs_examined) / count, seconds / n, cost.bytes / n,
                 static_cast<double>(cost.counts.unsolved) / count, cost.report.worst_residual,
                 cost.counts.deepest});
      std::printf(
          "  %5d bodies, %d threads: %.3g s a step, %.0f contacts, %.0f sweeps, unsolved %.2f, worst %.1e\n",
          n, threads, seconds, static_cast<double>(cost.counts.contacts) / count,
          static_cast<double>(cost.report.contact_iterations) / problems,
          static_cast<double>(cost.counts.unsolved) / count, cost.report.worst_residual);
      if (threads == 1) {
        sizes.push_back(n);
        times.push_back(seconds);
        one = seconds;
      } else {
        std::printf("        two threads %.2f times as fast\n", one / seconds);
      }
    }
  }
  char text[80];
  std::snprintf(text, sizeof text, "fitted exponent of seconds over bodies, 30 bodies and more: %.3f",
                exponent(sizes, times, 30));
  std::printf("  %s\n", text);
  table.comments.push_back(text);
  write_table(table, folder / "cost_bodies.tsv");
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, bench::run); }
