#include "costs.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <memory>

#include "common/stopwatch.hpp"

namespace bench {
namespace {

/// Seconds of a pass so long that one is enough.
constexpr double long_pass = 0.02;

/// Error and failures of what the last pass left.
void judge(CostRow& row, const Runner& runner) {
  const double solved = row.solver->tolerance > 0 ? 1000 * row.solver->tolerance : 1e-10;
  for (std::size_t i = 0; i < row.cases().size(); ++i) {
    const double residual = natural_map_residual(row.cases()[i].problem, runner.impulses()[i]);
    if (!(residual <= aimed_residual)) ++row.above_aim;
    if (residual <= solved) {
      row.error = std::max(row.error, residual);
    } else {
      ++row.failures;
    }
  }
}

}  // namespace

std::vector<CostRow> measure_solvers(const std::vector<Family>& families,
                                     const std::vector<SolverUnderTest>& solvers) {
  std::vector<CostRow> rows;
  std::vector<std::unique_ptr<Runner>> runners;
  std::vector<Task> tasks;
  std::vector<std::size_t> timed;
  for (const Family& family : families) {
    for (const SolverUnderTest& solver : solvers) {
      if ((solver.coulomb_only && !family.coulomb) || (solver.one_contact_only && !family.one_contact))
        continue;
      for (const bool warm : {false, true}) {
        CostRow row{&family, &solver, warm, 0, 0, 0, std::numeric_limits<double>::quiet_NaN()};
        auto runner = solver.prepare(row.cases());
        const Task task{[r = runner.get()] { r->pass(); }, static_cast<double>(row.cases().size())};
        const double once = time_interleaved({&task, 1}, {.rounds = 1, .visit = 0}).front().front();
        judge(row, *runner);
        const bool slow = once * task.evaluations > long_pass;
        if (slow) row.seconds = once;
        rows.push_back(row);
        if (slow) continue;
        if (2 * static_cast<std::size_t>(row.failures) > row.cases().size()) continue;
        timed.push_back(rows.size() - 1);
        tasks.push_back(task);
        runners.push_back(std::move(runner));
      }
    }
  }
  // The lower quartile: what else a machine does can only add to a time.
  const auto seconds = time_interleaved(tasks, {.rounds = 7, .visit = 2e-4, .budget = 0.02, .least = 2});
  for (std::size_t i = 0; i < tasks.size(); ++i) rows[timed[i]].seconds = quantile(seconds[i], 0.25);
  return rows;
}

}  // namespace bench
