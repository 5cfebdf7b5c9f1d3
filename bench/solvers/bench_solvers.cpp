// bench_solvers [--out FOLDER]
// What the contact problem costs: seconds per problem and residual reached, for every solver of ours and of
// Siconos.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "aims.hpp"
#include "common/pareto.hpp"
#include "common/program.hpp"
#include "contensou/output/table.hpp"
#include "costs.hpp"
#include "families.hpp"
#include "methods.hpp"
#ifdef CONTENSOU_HAS_SICONOS
#include "rivals/siconos.hpp"
using Quiet = rivals::Silence;
#else
struct Quiet {
  Quiet() {}
};
#endif

namespace bench {
namespace {

/// Of those of the same family and start that solve everything.
bool on_front(const CostRow& row, const std::vector<CostRow>& rows) {
  if (row.failures > 0 || std::isnan(row.seconds)) return false;
  return std::none_of(rows.begin(), rows.end(), [&](const CostRow& other) {
    return other.family == row.family && other.warm == row.warm && other.failures == 0 &&
           !std::isnan(other.seconds) && beats({other.error, other.seconds}, {row.error, row.seconds});
  });
}

std::string setting(const SolverUnderTest& solver) {
  return solver.tolerance > 0 ? "tolerance " + contensou::to_text(solver.tolerance) : "-";
}

contensou::Table cost_table(const std::vector<CostRow>& rows) {
  contensou::Table table{
      {"What the contact problem costs: time per problem and residual reached, for the solvers of this "
       "library and, "
       "where installed, of Siconos Numerics.",
       "family: coulomb_1, coulomb_1_free, uniform_1, hertz_1 one contact (Coulomb, Contensou with uniform "
       "or Hertz "
       "pressure), 600 "
       "problems; coulomb_n, contensou_n 2 to 8, 40 problems;",
       "  coulomb_1_free: W positive definite, impact or sliding; random_contact::random_problem (mass "
       "ratios to 1e6, "
       "rank-deficient, mu 0 to 10) in natural units, "
       "without "
       "those that open at once",
       "start: cold = from zero; warm = from the solution for a b that differs by up to 1 % of max|b| in "
       "each row",
       "error: natural_map_residual (ours) for all solvers alike, the largest over the problems solved; "
       "solved: at most "
       "1000 times the tolerance asked for (in the",
       "  solver's own measure; Siconos's is fc3d_compute_error, at most 1000 iterations); failures: "
       "problems not "
       "solved",
       "seconds: per problem, failures included; lower quartile over rounds of the fastest pass of a round; "
       "nan where "
       "more than half fail",
       "  ours: ContactSolver::solve with its checks and its certificate, one_contact: solve_one_contact "
       "alone; "
       "Siconos: fc3d_driver, everything else made ready before",
       "front: on the Pareto front (error, seconds) of those of its family and start that solve everything"},
      {"method", "setting", "error", "seconds", "family", "start", "origin", "failures", "problems", "front"},
      {}};
  for (const CostRow& row : rows) {
    table.add({row.solver->name, setting(*row.solver), row.error, row.seconds, row.family->name,
               row.warm ? "warm" : "cold", row.solver->origin, static_cast<double>(row.failures),
               static_cast<double>(row.cases().size()), on_front(row, rows) ? "yes" : "no"});
  }
  return table;
}

/// The fronts as curves: rows by family and start, then by time.
contensou::Table front_table(std::vector<CostRow> rows) {
  contensou::Table table{{"Pareto fronts of cost_solvers.tsv"},
                         {"family", "start", "error", "seconds", "method", "setting"},
                         {}};
  std::stable_sort(rows.begin(), rows.end(), [](const CostRow& a, const CostRow& b) {
    if (a.family != b.family) return a.family < b.family;
    if (a.warm != b.warm) return b.warm;
    return a.seconds < b.seconds;
  });
  for (const CostRow& row : rows) {
    if (!on_front(row, rows)) continue;
    table.add({row.family->name, row.warm ? "warm" : "cold", row.error, row.seconds, row.solver->name,
               setting(*row.solver)});
    std::printf("  %-12s %s  %-24s %-16s error %8.1e  %8.3g us\n", row.family->name.c_str(),
                row.warm ? "warm" : "cold", row.solver->name.c_str(), setting(*row.solver).c_str(), row.error,
                1e6 * row.seconds);
  }
  return table;
}

int run(const std::filesystem::path& folder) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Family> all = families();
  std::vector<SolverUnderTest> solvers = our_solvers();
  for (SolverUnderTest& solver : siconos_solvers()) solvers.push_back(std::move(solver));
  if (solvers.back().origin != "siconos") std::printf("Siconos is not installed: our solvers alone\n");
  std::vector<CostRow> rows;
  {
    const Quiet quiet;
    rows = measure_solvers(all, solvers);
  }
  contensou::write_table(cost_table(rows), folder / "cost_solvers.tsv");
  std::printf("Pareto fronts\n");
  contensou::write_table(front_table(rows), folder / "cost_solvers_front.tsv");
  std::printf("aims\n");
  contensou::Table aims;
  {
    const Quiet quiet;
    aims = measure_solver_aims(all, solvers, rows);
  }
  contensou::write_table(aims, folder / "cost_solver_ratios.tsv");
  for (const std::vector<std::string>& row : aims.rows) {
    std::printf("  %-90s %8.3g %s  aim %s  %s\n", row[0].c_str(), std::strtod(row[2].c_str(), nullptr),
                row[1].c_str(), row[3].c_str(), row[4].c_str());
  }
  std::printf("%.0f s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  return 0;
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, bench::run); }
