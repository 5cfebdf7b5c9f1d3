#include "aims.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/stopwatch.hpp"

namespace bench {
namespace {

using contensou::Method;

constexpr double aimed_error = 1e-6;    // [s], of every event before the accumulation
constexpr double aimed_seconds = 0.05;  // for the 8 s
constexpr double aimed_ratio = 100;     // rk4_printed's error to rk4's
constexpr double rk4_step = 1e-4;

class Aims {
 public:
  void add(const std::string& what, const std::string& unit, const std::vector<double>& values, double aim) {
    const bool ratio = unit == "1";
    // A ratio's median; of a time, to which everything else on the machine only adds, the lower quartile.
    const double value = quantile(values, ratio ? 0.5 : 0.25);
    const bool reached = ratio ? value >= aim : value < aim;
    const std::string aimed = aim > 0 ? (ratio ? ">= " : "< ") + contensou::to_text(aim) : "-";
    table_.add({what, unit, value, aimed,
                std::string(aim <= 0  ? "-"
                            : reached ? "yes"
                                      : "no"),
                quantile(values, 0.25), quantile(values), quantile(values, 0.75)});
  }
  const contensou::Table& table() const { return table_; }

 private:
  contensou::Table table_{
      {"The integrators against their aims, on one core; runs and errors as in cost_integrators.tsv",
       "8 s: the loosest tolerance of event_driven with every impact before the accumulation within 1e-6 s",
       "rk4_printed / rk4: the error of rk4_printed at a step at which it takes as long as rk4 at a step of "
       "1e-4 s, over rk4's error;",
       "  both in the axis formulation; between the steps of rk4_printed error and time are interpolated in "
       "their logarithms; rk4's error is taken for no less",
       "  than the reference's error bar. best step: of all of rk4_printed, however long it takes",
       "value: of a ratio, taken within a round, the median over interleaved rounds; of a time the lower "
       "quartile; with the median and the quartiles"},
      {"quantity", "unit", "value", "aim", "reached", "lower_quartile", "median", "upper_quartile"},
      {}};
};

/// The loosest tolerance that does it; none, null.
const CostRow* loosest(const std::vector<CostRow>& rows, const std::string& formulation) {
  const CostRow* found = nullptr;
  for (const CostRow& row : rows) {
    if (row.scheme.method != Method::event_driven || row.scheme.formulation != formulation) continue;
    if (row.whole.told() && row.errors.events <= aimed_error &&
        (!found || row.scheme.size > found->scheme.size))
      found = &row;
  }
  return found;
}

std::vector<std::vector<double>> time_runs(const std::vector<const CostRow*>& rows, double t_end,
                                           int rounds) {
  std::vector<Task> tasks;
  for (const CostRow* row : rows) {
    tasks.push_back({[&scheme = row->scheme, top = std::shared_ptr(paper_top(row->scheme.formulation)),
                      t_end] { story_of(*top, scheme, t_end); },
                     1});
  }
  return time_interleaved(tasks, {.rounds = rounds, .visit = 1e-3, .budget = 10});
}

/// The error at `seconds` on the line through ln seconds, ln error, by rising seconds; the ends' errors
/// beyond them.
double error_at(double seconds, const std::vector<std::pair<double, double>>& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].first < seconds) continue;
    if (i == 0) return line[0].second;
    const auto [t0, e0] = line[i - 1];
    const auto [t1, e1] = line[i];
    const double along = std::log(seconds / t0) / std::log(t1 / t0);
    return e0 * std::pow(e1 / e0, along);
  }
  return line.back().second;
}

/// One error of a run, by name.
struct Measure {
  const char* name;
  double Errors::*error;
};

/// rk4_printed against rk4 in runs to t_end.
void compare(const std::vector<Measure>& measures, const std::vector<CostRow>& rows,
             const Reference& reference, double t_end, Aims& aims) {
  const auto rk4 = std::find_if(rows.begin(), rows.end(), [](const CostRow& row) {
    return row.scheme.method == Method::rk4 && row.scheme.formulation == "axis" &&
           row.scheme.size == rk4_step;
  });
  if (rk4 == rows.end()) throw std::runtime_error("bench_integrators: rk4 fails at a step of 1e-4 s");
  std::vector<const CostRow*> printed;
  for (const CostRow& row : rows) {
    if (row.scheme.method == Method::rk4_printed && row.scheme.formulation == "axis") printed.push_back(&row);
  }
  if (printed.empty()) throw std::runtime_error("bench_integrators: rk4_printed fails at all steps");

  // Of rk4_printed those steps alone are timed again that take about as long as rk4.
  const auto seconds = [&](const CostRow& row) {
    return t_end > early_motion ? row.seconds : row.seconds_early;
  };
  std::vector<const CostRow*> timed{&*rk4};
  for (const CostRow* row : printed) {
    if (std::abs(std::log(seconds(*row) / seconds(*rk4))) < std::log(3)) timed.push_back(row);
  }
  if (timed.size() == 1) timed.push_back(printed.back());
  const auto times = time_runs(timed, t_end, 7);

  for (const Measure& measure : measures) {
    const auto error = [&](const CostRow& row) { return row.errors.*measure.error; };
    const double ours = std::max(error(*rk4), reference.bars.*measure.error);
    std::vector<double> ratios;
    for (std::size_t round = 0; round < times[0].size(); ++round) {
      std::vector<std::pair<double, double>> line;
      for (std::size_t i = 1; i < timed.size(); ++i) line.push_back({times[i][round], error(*timed[i])});
      std::sort(line.begin(), line.end());
      ratios.push_back(error_at(times[0][round], line) / ours);
    }
    const auto best =
        std::min_element(printed.begin(), printed.end(),
                         [&](const CostRow* a, const CostRow* b) { return error(*a) < error(*b); });
    const std::string what = std::string("rk4, ") + measure.name;
    aims.add("rk4_printed / " + what, "1", ratios, aimed_ratio);
    aims.add("rk4_printed at its best step / " + what, "1", {error(**best) / ours}, 0);
  }
}

}  // namespace

contensou::Table measure_integrator_aims(const Reference& reference, const std::vector<CostRow>& rows) {
  Aims aims;
  std::vector<const CostRow*> quick;
  for (const char* formulation : {"axis", "euler"}) {
    if (const CostRow* row = loosest(rows, formulation)) quick.push_back(row);
  }
  if (quick.empty())
    aims.add("8 s, event_driven: no tolerance tried is enough", "s", {INFINITY}, aimed_seconds);
  const auto seconds = time_runs(quick, whole_motion, 41);
  for (std::size_t i = 0; i < quick.size(); ++i) {
    char within[40];
    std::snprintf(within, sizeof within, " (events within %.1e s)", quick[i]->errors.events);
    aims.add("8 s, event_driven, " + setting(quick[i]->scheme) + within, "s", seconds[i], aimed_seconds);
  }
  compare({{"every event", &Errors::events},
           {"the two touches", &Errors::touches},
           {"theta(8 s)", &Errors::theta_end}},
          rows, reference, whole_motion, aims);
  compare({{"theta(1 s)", &Errors::theta_early}}, rows, reference, early_motion, aims);
  return aims.table();
}

}  // namespace bench
