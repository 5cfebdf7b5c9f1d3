// bench_projection [--out FOLDER]
// What the projection on the friction ball costs: seconds and largest error of every way to compute it.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <memory>

#include "aims.hpp"
#include "common/pareto.hpp"
#include "common/program.hpp"
#include "common/stopwatch.hpp"
#include "contensou/output/table.hpp"
#include "methods.hpp"
#include "points.hpp"

namespace bench {
namespace {

constexpr std::size_t count = 4096;

struct Errors {
  double largest = 0;
  double mean = 0;
};

Errors errors_of(const ProjectionMethod& method, const std::vector<Point>& points, Forces forces) {
  std::vector<Eigen::Vector3d> nearest(forces.size());
  method.project(forces, nearest);
  Errors errors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    long double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const long double difference = nearest[i][static_cast<Eigen::Index>(k)] - points[i].nearest[k];
      square += difference * difference;
    }
    const double distance = static_cast<double>(std::sqrt(square));
    errors.largest = worse(errors.largest, distance);
    errors.mean += distance / static_cast<double>(points.size());
  }
  return errors;
}

/// The forces of one pressure: all, and those of each place.
struct Sample {
  std::vector<Point> points;
  std::vector<Eigen::Vector3d> all;
  std::array<std::vector<Eigen::Vector3d>, 3> at;
};

Sample sample(const std::filesystem::path& reference, const std::string& pressure) {
  Sample s{points(reference, pressure, count), {}, {}};
  for (const Point& point : s.points) {
    s.all.push_back(point.force);
    s.at[static_cast<std::size_t>(point.place)].push_back(point.force);
  }
  return s;
}

/// Seconds per projection.
struct Seconds {
  double each, chain, inside, near, far;
};

/// Times every method on the same forces, all interleaved.
std::vector<Seconds> time_all(const std::vector<ProjectionMethod>& methods,
                              const std::map<std::string, Sample>& samples) {
  std::vector<Eigen::Vector3d> nearest(count);
  volatile double sink = 0;
  std::vector<Task> tasks;
  for (const ProjectionMethod& method : methods) {
    const Sample& s = samples.at(method.pressure);
    const auto add = [&](const std::vector<Eigen::Vector3d>& forces) {
      tasks.push_back({[&method, &forces, &nearest] { method.project(forces, nearest); },
                       static_cast<double>(forces.size())});
    };
    add(s.all);
    tasks.push_back({[&method, &s, &sink] { sink = method.chain(s.all); }, count});
    for (const auto& forces : s.at) add(forces);
  }
  std::printf("  %zu methods, %zu timings\n", methods.size(), tasks.size());
  std::fflush(stdout);
  // The lower quartile: what else a machine does can only add to a time.
  const auto rounds = time_interleaved(tasks, {.rounds = 21, .visit = 1e-3, .budget = 0.3});
  std::vector<Seconds> seconds;
  for (std::size_t i = 0; i < tasks.size(); i += 5) {
    const auto quartile = [&](std::size_t k) { return quantile(rounds[i + k], 0.25); };
    seconds.push_back({quartile(0), quartile(1), quartile(2), quartile(3), quartile(4)});
  }
  return seconds;
}

struct Row {
  const ProjectionMethod* method;
  Errors errors;
  Seconds seconds;
};

/// Nothing else of the same pressure is both at least as exact and faster (or as fast and more exact).
bool on_front(const Row& row, const std::vector<Row>& rows) {
  return std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
    return other.method->pressure == row.method->pressure &&
           beats({other.errors.largest, other.seconds.each}, {row.errors.largest, row.seconds.each});
  });
}

/// The fronts as curves: rows by pressure, then by time.
contensou::Table fronts(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return std::pair(a.method->pressure, a.seconds.each) < std::pair(b.method->pressure, b.seconds.each);
  });
  contensou::Table table{
      {"Pareto fronts of cost_projection.tsv"}, {"pressure", "error", "seconds", "method", "setting"}, {}};
  for (const Row& row : rows) {
    if (!on_front(row, rows)) continue;
    table.add(
        {row.method->pressure, row.errors.largest, row.seconds.each, row.method->name, row.method->setting});
  }
  return table;
}

contensou::Table empty_table() {
  return {{"What the projection on the friction ball costs: time and largest error of ways to compute it",
           "error: largest distance, in units of mu lambda_N, between what the method gives and the nearest "
           "point of the exact ball;",
           "  mean_error: its mean. The exact nearest points come from no projection: 4096 forces, a quarter "
           "inside (parts of border",
           "  points), half 1e-3 to 0.1 mu lambda_N outside, a quarter 0.1 to 1000, each a border point of "
           "reference_data (34 digits) plus",
           "  a distance along the normal there; normals even in angle, random directions around the axis. "
           "Known to 2e-16.",
           "seconds: per projection, all forces in random order; lower quartile over rounds of the fastest "
           "pass of a round",
           "seconds_chain: the same, each force waiting for the result before it; seconds_inside, _near, "
           "_far: the forces of one kind alone",
           "iterations, most_iterations: border points evaluated for one force, mean and maximum",
           "front: on the Pareto front of its pressure (error, seconds), yes or no"},
          {"method", "setting", "pressure", "error", "mean_error", "seconds", "seconds_chain",
           "seconds_inside", "seconds_near", "seconds_far", "iterations", "most_iterations", "front"},
          {}};
}

void measure_costs(const std::filesystem::path& reference, const std::filesystem::path& data) {
  const std::vector<ProjectionMethod> methods = projection_methods();
  std::map<std::string, Sample> samples;
  for (const ProjectionMethod& method : methods) {
    if (!samples.contains(method.pressure)) samples[method.pressure] = sample(reference, method.pressure);
  }
  const std::vector<Seconds> seconds = time_all(methods, samples);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const Sample& s = samples.at(methods[i].pressure);
    rows.push_back({&methods[i], errors_of(methods[i], s.points, s.all), seconds[i]});
  }
  contensou::Table table = empty_table();
  for (const Row& row : rows) {
    const ProjectionMethod& m = *row.method;
    const auto [mean, most] = m.iterations(samples.at(m.pressure).all);
    const Seconds& t = row.seconds;
    const std::string front = on_front(row, rows) ? "yes" : "no";
    table.add({m.name, m.setting, m.pressure, row.errors.largest, row.errors.mean, t.each, t.chain, t.inside,
               t.near, t.far, mean, static_cast<double>(most), front});
    std::printf(
        "  %-8s %-13s %-20s error %8.2g  %6.1f ns, chain %6.1f, in %6.1f near %6.1f far %6.1f  %4.1f "
        "iterations  %s\n",
        m.pressure.c_str(), m.name.c_str(), m.setting.c_str(), row.errors.largest, 1e9 * t.each,
        1e9 * t.chain, 1e9 * t.inside, 1e9 * t.near, 1e9 * t.far, mean, front.c_str());
  }
  contensou::write_table(fronts(rows), data / "cost_projection_front.tsv");
  contensou::write_table(table, data / "cost_projection.tsv");
}

int run(const std::filesystem::path& folder) {
  const std::filesystem::path reference = CONTENSOU_REFERENCE_DATA;
  const auto start = std::chrono::steady_clock::now();
  std::printf("aims\n");
  contensou::write_table(measure_projection_aims(reference), folder / "cost_projection_aims.tsv");
  std::printf("cost of the projection\n");
  measure_costs(reference, folder);
  std::printf("%.0f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, bench::run); }
