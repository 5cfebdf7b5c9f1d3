// bench_laws [--out FOLDER]
// What accuracy costs: seconds per evaluation and largest
// error of every way to compute the uniform and the Hertz law.
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>

#include "common/pareto.hpp"
#include "common/program.hpp"
#include "common/stopwatch.hpp"
#include "contensou/output/table.hpp"
#include "methods.hpp"
#include "ratios.hpp"
#include "sample.hpp"

namespace bench {
namespace {

struct Errors {
  double scaled = 0;    ///< the error of the table, see its header
  double relative = 0;  ///< the largest relative error of the three
  std::size_t points = 0;
};

struct Results {
  explicit Results(std::size_t count) : phi(count), xi(count), eta(count) {}
  contensou::ReducedBatch span() { return {phi, xi, eta}; }
  std::vector<double> phi;
  std::vector<double> xi;
  std::vector<double> eta;
};

Errors errors_of(const Method& method, const std::vector<Exact>& exact, std::size_t stride) {
  const long double eta_max = method.pressure == "uniform" ? 2.0L / 3 : 3 * std::acos(-1.0L) / 16;
  std::vector<double> u;
  std::vector<const Exact*> rows;
  for (std::size_t i = 0; i < exact.size(); i += stride) {
    u.push_back(exact[i].u);
    rows.push_back(&exact[i]);
  }
  Results results(u.size());
  method.evaluate(u, results.span());
  Errors errors;
  errors.points = u.size();
  for (std::size_t i = 0; i < u.size(); ++i) {
    const long double phi = std::abs(results.phi[i] - rows[i]->phi);
    const long double xi = std::abs(results.xi[i] - rows[i]->xi);
    const long double eta = std::abs(results.eta[i] - rows[i]->eta);
    for (const long double scaled : {phi / rows[i]->phi, xi, eta / eta_max}) {
      errors.scaled = worse(errors.scaled, static_cast<double>(scaled));
    }
    for (const long double relative : {phi / rows[i]->phi, xi / rows[i]->xi, eta / rows[i]->eta}) {
      errors.relative = worse(errors.relative, static_cast<double>(relative));
    }
  }
  return errors;
}

/// The number of arguments for one pass: all, or for a slow
/// method as many as fit in a few milliseconds, at least 32.
std::size_t sample_size(const Method& method) {
  constexpr std::size_t largest = 16384;
  constexpr std::size_t least = 32;
  constexpr double pass = 0.5e-3;
  const std::vector<double> u = log_uniform_sample(least);
  Results results(least);
  const Task once{[&] { method.evaluate(u, results.span()); }, static_cast<double>(least)};
  const double seconds = time_interleaved({&once, 1}, {.rounds = 1, .visit = 0}).front().front();
  return static_cast<std::size_t>(std::clamp(pass / seconds, double{least}, double{largest}));
}

/// The arguments of one method's timing, in random order and sorted.
struct Timing {
  explicit Timing(std::size_t count) : random(log_uniform_sample(count)), sorted(random), results(count) {
    std::sort(sorted.begin(), sorted.end());
  }
  std::vector<double> random;
  std::vector<double> sorted;
  Results results;
  double sink = 0;
};

struct Row {
  const Method* method;
  Errors errors;
  double seconds;
  double seconds_sorted = std::numeric_limits<double>::quiet_NaN();
  double seconds_chain = std::numeric_limits<double>::quiet_NaN();
};

/// Nothing else of the same pressure is both at least as exact and faster (or as fast and more exact).
bool on_front(const Row& row, const std::vector<Row>& rows, bool one_by_one) {
  const Cost cost{row.errors.scaled, row.seconds};
  if (std::isnan(cost.error) || (one_by_one && !row.method->chain)) return false;
  return std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
    if (other.method->pressure != row.method->pressure || (one_by_one && !other.method->chain)) return false;
    return beats({other.errors.scaled, other.seconds}, cost);
  });
}

/// The fronts as curves: rows by pressure, then by time.
contensou::Table fronts(std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.seconds < b.seconds; });
  contensou::Table table{
      {"Pareto fronts of cost_laws.tsv: among all methods, and among those that take one value at a time"},
      {"pressure", "among", "error", "seconds", "method", "setting"},
      {}};
  for (const char* pressure : {"uniform", "hertz"}) {
    for (const bool one_by_one : {false, true}) {
      for (const Row& row : rows) {
        if (row.method->pressure != pressure || !on_front(row, rows, one_by_one)) continue;
        table.add({pressure, one_by_one ? "one" : "all", row.errors.scaled, row.seconds, row.method->name,
                   row.method->setting});
      }
    }
  }
  return table;
}

void measure_costs(const std::filesystem::path& reference, const std::filesystem::path& data) {
  constexpr std::size_t slow = 512;      // arguments in a pass, below which only one order is timed
  constexpr double longest_check = 2.0;  // seconds for the error of one method
  const std::vector<Method> methods = law_methods();
  const std::vector<Exact> uniform = read_exact(reference / "laws" / "uniform.tsv");
  const std::vector<Exact> hertz = read_exact(reference / "laws" / "hertz.tsv");

  std::vector<std::unique_ptr<Timing>> timings;
  std::vector<Row> rows;
  std::vector<Task> tasks;
  struct Use {
    std::size_t row;
    double Row::*seconds;
  };
  std::vector<Use> uses;
  for (const Method& method : methods) {
    const std::size_t count = sample_size(method);
    timings.push_back(std::make_unique<Timing>(count));
    Timing& t = *timings.back();
    const std::vector<Exact>& exact = method.pressure == "uniform" ? uniform : hertz;
    const Task once{[&] { method.evaluate(t.random, t.results.span()); }, static_cast<double>(count)};
    const double seconds = time_interleaved({&once, 1}, {.rounds = 1, .visit = 0}).front().front();
    const double all = seconds * static_cast<double>(exact.size());
    const std::size_t stride = static_cast<std::size_t>(std::ceil(all / longest_check));
    rows.push_back({&method, errors_of(method, exact, std::max<std::size_t>(stride, 1)), 0});
    const double evaluations = static_cast<double>(count);
    tasks.push_back({[&method, &t] { method.evaluate(t.random, t.results.span()); }, evaluations});
    uses.push_back({rows.size() - 1, &Row::seconds});
    if (count < slow) continue;
    tasks.push_back({[&method, &t] { method.evaluate(t.sorted, t.results.span()); }, evaluations});
    uses.push_back({rows.size() - 1, &Row::seconds_sorted});
    if (!method.chain) continue;
    tasks.push_back({[&method, &t] { t.sink = method.chain(t.random); }, evaluations});
    uses.push_back({rows.size() - 1, &Row::seconds_chain});
  }
  std::printf("  %zu methods, %zu timings\n", methods.size(), tasks.size());
  std::fflush(stdout);
  // The lower quartile: what else a machine does can only add to a time.
  const auto seconds = time_interleaved(tasks, {.rounds = 25});
  for (std::size_t i = 0; i < tasks.size(); ++i)
    rows[uses[i].row].*uses[i].seconds = quantile(seconds[i], 0.25);

  contensou::Table table{{"What accuracy costs: time and largest error of ways to compute Phi, xi and eta of "
                          "the uniform and the Hertz law",
                          "error: maximum over u in [1e-3, 1e3] of the relative error of Phi and of the "
                          "errors of xi and eta in units of their",
                          "  largest values (1 and eta(0)), that is of the friction force in mu lambda_N and "
                          "of the torque in its value without sliding",
                          "relative_error: maximum of the relative errors of Phi, xi and eta themselves, "
                          "which shows digits lost where eta is small",
                          "seconds: per evaluation of Phi, xi, eta together, u log-uniform over [1e-3, 1e3] "
                          "in random order; lower quartile over rounds of the",
                          "  fastest pass of a round; seconds_sorted: the same u in ascending order; "
                          "seconds_chain: each waits for the one before",
                          "points: exact values compared with (reference_data/laws; fewer for slow methods)",
                          "front: on the Pareto front of all methods (all), or of those that take one value "
                          "at a time (one); - otherwise"},
                         {"method", "setting", "pressure", "error", "relative_error", "seconds",
                          "seconds_sorted", "seconds_chain", "points", "front"},
                         {}};
  for (const Row& row : rows) {
    const std::string front = on_front(row, rows, false) ? "all" : on_front(row, rows, true) ? "one" : "-";
    table.add({row.method->name, row.method->setting, row.method->pressure, row.errors.scaled,
               row.errors.relative, row.seconds, row.seconds_sorted, row.seconds_chain,
               static_cast<double>(row.errors.points), front});
    std::printf("  %-8s %-22s %-24s error %8.2g  relative %8.2g  %10.3g s  %s\n",
                row.method->pressure.c_str(), row.method->name.c_str(), row.method->setting.c_str(),
                row.errors.scaled, row.errors.relative, row.seconds, front.c_str());
  }
  contensou::write_table(fronts(rows), data / "cost_laws_front.tsv");
  contensou::write_table(table, data / "cost_laws.tsv");
}

int run(const std::filesystem::path& folder) {
  gsl_set_error_handler_off();  // a quadrature that gives up is measured, it does not end the program
  const auto start = std::chrono::steady_clock::now();
  std::printf("ratios\n");
  contensou::write_table(measure_ratios(), folder / "cost_ratios.tsv");
  std::printf("cost of accuracy\n");
  measure_costs(CONTENSOU_REFERENCE_DATA, folder);
  std::printf("%.0f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, bench::run); }
