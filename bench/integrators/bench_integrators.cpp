// bench_integrators [--out FOLDER]
// What the motion of the tippe-top of LG03 5.4 costs: errors of event times and inclinations against wall
// time, for every integrator, both formulations, over steps and tolerances.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "aims.hpp"
#include "common/pareto.hpp"
#include "common/program.hpp"
#include "contensou/output/table.hpp"
#include "costs.hpp"

namespace bench {
namespace {

/// What a front is about.
struct Measure {
  const char* name;
  double Errors::*error;
  double CostRow::*seconds;
};
constexpr Measure measures[] = {{"events", &Errors::events, &CostRow::seconds},
                                {"theta_1s", &Errors::theta_early, &CostRow::seconds_early},
                                {"theta_end", &Errors::theta_end, &CostRow::seconds}};

/// Of all that tell the story. Errors below the reference's error bar rank as equal.
bool on_front(const CostRow& row, const std::vector<CostRow>& rows, const Measure& measure,
              const Reference& reference) {
  const auto cost = [&](const CostRow& of) {
    return Cost{std::max(of.errors.*measure.error, reference.bars.*measure.error), of.*measure.seconds};
  };
  return std::none_of(rows.begin(), rows.end(),
                      [&](const CostRow& other) { return beats(cost(other), cost(row)); });
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1e", x);
  return text;
}

std::string exactly(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12f", x);
  return text;
}

contensou::Table cost_table(const std::vector<CostRow>& rows, const Reference& reference) {
  const std::vector<double>& impacts = reference.whole.impacts;
  const Errors& bars = reference.bars;
  contensou::Table table{
      {"What the motion of the tippe-top costs: 8 s of LG03 Section 5.4 (Hertz pressure, R = 5e-4 m, mu = "
       "0.3, resting on the floor at t = 0), by",
       "every integrator, in both formulations. Times in s, angles in rad. Runs that do not tell the story "
       "are in cost_integrators_failures.tsv.",
       "error: largest error of the times of the " + std::to_string(impacts.size()) +
           " impacts before the accumulation (the tip touches, the body touches, then each in turn), the "
           "k-th "
           "against the k-th.",
       "  Bouncing of one contact while the other stays open counts once, what the body does in the second "
       "after the tip's touch as that touch. Where a run has",
       "  fewer impacts, the missing ones are where its impacts end.",
       "error_touches: of the first two; error_accumulation: of the end of the impacts (of a scheme that "
       "does not know accumulations: its last impact of the series);",
       "  error_theta_1s, error_theta_end: of the inclination at 1 s, before any event, and at 8 s",
       "seconds: wall time of the 8 s on one core, nothing shown between start and end; lower quartile over "
       "up to 15 interleaved rounds of the fastest pass of a",
       "  round (runs of more than 0.2 s: once); seconds_1s: of a run of 1 s; steps: of the 8 "
       "s; "
       "size: step in s or tolerance",
       "front: on the Pareto front (error, seconds) of all rows",
       "reference: event_driven, axis, tolerance 3e-15. Its error bars are the largest distance to " +
           reference.witnesses + ":",
       "  touches " + exactly(impacts[0]) + " and " + exactly(impacts[1]) + " +- " + number(bars.touches) +
           ", events +- " + number(bars.events) + ", accumulation " + exactly(reference.whole.accumulation) +
           " +- " + number(bars.accumulation) + ", theta(1 s) " + exactly(reference.theta_early) + " +- " +
           number(bars.theta_early) + ", theta(8 s) " + exactly(reference.whole.theta) + " +- " +
           number(bars.theta_end),
       "  An error below its bar says only that."},
      {"method", "setting", "error", "seconds", "formulation", "size", "error_touches", "error_accumulation",
       "error_theta_end", "error_theta_1s", "seconds_1s", "impacts", "steps", "front"},
      {}};
  for (const CostRow& row : rows) {
    const Errors& e = row.errors;
    const char* method = name(row.scheme.method);
    const char* front = on_front(row, rows, measures[0], reference) ? "yes" : "no";
    table.add({std::string(method), setting(row.scheme), e.events, row.seconds, row.scheme.formulation,
               row.scheme.size, e.touches, e.accumulation, e.theta_end, e.theta_early, row.seconds_early,
               static_cast<double>(row.whole.impacts.size()), static_cast<double>(row.whole.steps),
               std::string(front)});
    std::printf(
        "  %-16s %-24s events %7.1e touches %7.1e end %7.1e  %9.3g ms   theta(1 s) %7.1e  %9.3g ms  %s\n",
        method, setting(row.scheme).c_str(), e.events, e.touches, e.theta_end, 1e3 * row.seconds,
        e.theta_early, 1e3 * row.seconds_early, front);
  }
  return table;
}

/// The fronts as curves: by measure, then by time.
contensou::Table front_table(std::vector<CostRow> rows, const Reference& reference) {
  contensou::Table table{{"Pareto fronts of cost_integrators.tsv, of three of its errors: events (error, "
                          "seconds), theta_1s (error_theta_1s,",
                          "seconds_1s), theta_end (error_theta_end, seconds). error_bar: the reference's; "
                          "errors below it rank as equal"},
                         {"measure", "error", "seconds", "method", "setting", "error_bar"},
                         {}};
  for (const Measure& measure : measures) {
    std::sort(rows.begin(), rows.end(),
              [&](const CostRow& a, const CostRow& b) { return a.*measure.seconds < b.*measure.seconds; });
    for (const CostRow& row : rows) {
      if (!on_front(row, rows, measure, reference)) continue;
      table.add({std::string(measure.name), row.errors.*measure.error, row.*measure.seconds,
                 std::string(name(row.scheme.method)), setting(row.scheme), reference.bars.*measure.error});
    }
  }
  return table;
}

contensou::Table failure_table(const std::vector<CostRow>& rows) {
  contensou::Table table{
      {"Runs of cost_integrators.tsv that do not tell the story, and how far they came. "
       "At t = 0.1441 s the inclination falls to",
       "2e-4 rad, close to the singularity of the Euler angles at 0: there most fixed steps fail in them"},
      {"method", "setting", "formulation", "size", "outcome", "t"},
      {}};
  for (const CostRow& row : rows) {
    if (row.whole.told()) continue;
    table.add({std::string(name(row.scheme.method)), setting(row.scheme), row.scheme.formulation,
               row.scheme.size, row.whole.failure, row.whole.t});
    std::printf("  %-16s %-24s %s, t = %.4g s\n", name(row.scheme.method), setting(row.scheme).c_str(),
                row.whole.failure.c_str(), row.whole.t);
  }
  return table;
}

int run(const std::filesystem::path& folder) {
  const auto start = std::chrono::steady_clock::now();
  const Reference truth = reference();
  std::printf("what the motion of the tippe-top costs\n");
  const std::vector<CostRow> all = measure_integrators(truth);
  std::vector<CostRow> told;
  std::copy_if(all.begin(), all.end(), std::back_inserter(told),
               [](const CostRow& row) { return row.whole.told(); });
  const contensou::Table costs = cost_table(told, truth);
  contensou::write_table(front_table(told, truth), folder / "cost_integrators_front.tsv");
  std::printf("runs that fail\n");
  contensou::write_table(failure_table(all), folder / "cost_integrators_failures.tsv");
  std::printf("aims\n");
  const contensou::Table aims = measure_integrator_aims(truth, told);
  contensou::write_table(aims, folder / "cost_integrators_aims.tsv");
  for (const std::vector<std::string>& row : aims.rows) {
    std::printf("  %-90s %8.3g %s  aim %s  %s\n", row[0].c_str(), std::strtod(row[2].c_str(), nullptr),
                row[1].c_str(), row[3].c_str(), row[4].c_str());
  }
  contensou::write_table(costs, folder / "cost_integrators.tsv");
  std::printf("%.0f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, bench::run); }
