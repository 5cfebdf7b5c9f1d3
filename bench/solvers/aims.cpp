#include "aims.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "common/stopwatch.hpp"

namespace bench {
namespace {

/// One solver on one family, cold, to be timed.
struct Entry {
  const Family* family;
  const SolverUnderTest* solver;
  std::unique_ptr<Runner> runner;
};

class Entries {
 public:
  std::size_t add(const Family& family, const SolverUnderTest& solver) {
    entries_.push_back({&family, &solver, solver.prepare(family.cold)});
    return entries_.size() - 1;
  }

  std::vector<std::vector<double>> time() const {
    std::vector<Task> tasks;
    for (const Entry& e : entries_) {
      tasks.push_back({[&e] { e.runner->pass(); }, static_cast<double>(e.family->cold.size())});
    }
    return time_interleaved(tasks, {.rounds = 41, .visit = 1e-3, .budget = 10});
  }

 private:
  std::vector<Entry> entries_;
};

const SolverUnderTest& ours(const std::vector<SolverUnderTest>& solvers, const std::string& name) {
  const auto found = std::find_if(solvers.begin(), solvers.end(), [&](const SolverUnderTest& s) {
    return s.origin == "contensou" && s.name == name && (s.tolerance == aimed_residual || s.tolerance == 0);
  });
  if (found == solvers.end()) throw std::logic_error("bench_solvers: no solver of ours is called " + name);
  return *found;
}

/// Siconos's fastest that solves all problems of the family to the aimed residual; where none does, the
/// fastest of those that leave at most one in a hundred.
const CostRow* best_rival(const Family& family, const std::vector<CostRow>& rows) {
  const CostRow* best = nullptr;
  const auto rank = [](const CostRow& row) { return std::pair(row.above_aim > 0, row.seconds); };
  for (const CostRow& row : rows) {
    if (row.family != &family || row.warm || row.solver->origin != "siconos" || !(row.seconds > 0)) continue;
    if (100 * static_cast<std::size_t>(row.above_aim) > row.cases().size()) continue;
    if (!best || rank(row) < rank(*best)) best = &row;
  }
  return best;
}

class Aims {
 public:
  void add(const std::string& what, const std::string& unit, const std::vector<double>& values, double aim,
           bool at_least) {
    // A ratio's median; of a time, to which everything else on the machine only adds, the lower quartile.
    const double value = quantile(values, unit == "1" ? 0.5 : 0.25);
    const bool reached = at_least ? value >= aim : value < aim;
    const std::string aimed = aim > 0 ? (at_least ? ">= " : "< ") + contensou::to_text(aim) : "-";
    const std::string verdict = aim <= 0 ? "-" : reached ? "yes" : "no";
    table_.add({what, unit, value, aimed, verdict, quantile(values, 0.25), quantile(values),
                quantile(values, 0.75)});
  }
  const contensou::Table& table() const { return table_; }

 private:
  contensou::Table table_{
      {"The contact solvers against their aims; problems, cold, as in cost_solvers.tsv, to be solved to "
       "1e-12 of "
       "natural_map_residual.",
       "Siconos: the fastest of its solvers and tolerances that solves them all; where none does, the "
       "fastest of "
       "those that leave at most one in a hundred, how many in brackets",
       "one_contact: solve_one_contact called with the law's type; automatic: ContactSolver, which checks "
       "the problem, "
       "looks up the law and certifies the residual",
       "value: of a ratio, taken within a round, the median over 41 interleaved rounds of the fastest pass "
       "of a round; "
       "of a time the lower quartile; with the median and the quartiles"},
      {"quantity", "unit", "value", "aim", "reached", "lower_quartile", "median", "upper_quartile"},
      {}};
};

}  // namespace

contensou::Table measure_solver_aims(const std::vector<Family>& families,
                                     const std::vector<SolverUnderTest>& solvers,
                                     const std::vector<CostRow>& rows) {
  Entries entries;
  struct Measured {
    const Family* family;
    std::size_t automatic, direct, rival;
    const CostRow* rival_row;
  };
  std::vector<Measured> measured;
  for (const Family& family : families) {
    Measured m{&family, entries.add(family, ours(solvers, "automatic")), 0, 0, nullptr};
    if (family.one_contact) m.direct = entries.add(family, ours(solvers, "one_contact"));
    m.rival_row = best_rival(family, rows);
    if (m.rival_row) m.rival = entries.add(family, *m.rival_row->solver);
    measured.push_back(m);
  }
  const auto seconds = entries.time();
  const auto ratio = [&](std::size_t a, std::size_t b) {
    std::vector<double> of_round;
    for (std::size_t i = 0; i < seconds[a].size(); ++i) of_round.push_back(seconds[a][i] / seconds[b][i]);
    return of_round;
  };
  Aims aims;
  for (const Measured& m : measured) {
    const std::string& name = m.family->name;
    if (m.rival_row) {
      const SolverUnderTest& best = *m.rival_row->solver;
      const std::string rival = name + ", Siconos's " + best.name + " (tolerance " +
                                contensou::to_text(best.tolerance) + ", leaves " +
                                std::to_string(m.rival_row->above_aim) + " of " +
                                std::to_string(m.rival_row->cases().size()) + ")";
      const double aim = m.family->one_contact ? 5 : 0;
      aims.add(rival + " / automatic", "1", ratio(m.rival, m.automatic), aim, true);
      if (m.family->one_contact) aims.add(rival + " / one_contact", "1", ratio(m.rival, m.direct), aim, true);
      aims.add(rival, "s", seconds[m.rival], 0, false);
    }
    const double aim = m.family->one_contact && !m.family->coulomb ? 2e-6 : 0;
    aims.add(name + ", automatic", "s", seconds[m.automatic], aim, false);
    if (m.family->one_contact) aims.add(name + ", one_contact", "s", seconds[m.direct], aim, false);
  }
  return aims.table();
}

}  // namespace bench
