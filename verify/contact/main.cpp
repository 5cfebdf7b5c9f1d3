// How reliable the contact solvers are, on random problems that have a solution by theorem. Writes
// robustness.tsv, robustness_by_class.tsv and robustness_profile.tsv.   verify_contact [--out FOLDER]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/program.hpp"
#include "contact/inclusion.hpp"
#include "contact/random_problems.hpp"
#include "contensou/contact/contact_solver.hpp"
#include "contensou/output/table.hpp"
#include "record.hpp"

namespace verify::contact {
namespace {

using contensou::SolverMethod;

// A problem counts as solved at this natural-map residual.
constexpr double solved = 1e-10;
// A residual is explained by rounding up to this many times what one rounding of Λ does. A solver sees γ with
// the roundings of 32 products and 32 sums, which add as a random walk does: 8; and twice that.
constexpr double roundings = 16;

/// Whether no doubles can be expected to be better: both the natural map and the contact laws as written, the
/// latter in long double and without projections, hold to the effect of rounding Λ.
bool at_rounding(const contensou::ContactProblem& problem, const Eigen::VectorXd& impulse, double residual) {
  const double explained = roundings * random_contact::rounding_spread(problem, impulse);
  return residual <= explained && random_contact::inclusion_residual(problem, impulse) <= 2 * explained;
}

struct Method {
  std::string name;
  SolverMethod method;
  std::uint64_t problems;  ///< the first of them
};

/// The slow ones take a subset.
const std::vector<Method> methods{{"automatic", SolverMethod::automatic, 100000},
                                  {"semismooth_newton", SolverMethod::semismooth_newton, 20000},
                                  {"gauss_seidel", SolverMethod::gauss_seidel, 10000},
                                  {"modified_newton", SolverMethod::modified_newton, 10000}};

struct Count {
  int problems = 0;
  int unsolved = 0;
  double worst = 0;
};

struct Outcome {
  Count all;
  int at_rounding = 0;  ///< of the unsolved
  double worst_inclusion = 0;
  double inclusion_ratio = 0;  ///< worst, over twice (1e-10 and what rounding explains)
  double seconds = 0;
  std::vector<int> iterations;
  std::vector<double> times;  ///< of the solved
  std::map<std::pair<std::string, std::string>, Count> classes;
};

std::vector<std::pair<std::string, std::string>> classes_of(const random_contact::RandomProblem& p) {
  using namespace random_contact;
  const auto name = [](const auto& names, auto value) {
    return std::string(names[static_cast<std::size_t>(value)]);
  };
  return {{"structure", name(structures, p.structure)},
          {"motion", name(motions, p.motion)},
          {"rows", name(row_kinds, p.rows)},
          {"mu", name(roughnesses, p.roughness)},
          {"contacts", std::to_string(p.problem.contacts())}};
}

Outcome run_method(const Method& method) {
  using Clock = std::chrono::steady_clock;
  contensou::ContactSolver solver({.method = method.method, .tolerance = solved});
  Outcome outcome;
  Eigen::VectorXd impulse;
  for (std::uint64_t seed = 0; seed < method.problems; ++seed) {
    const random_contact::RandomProblem random = random_contact::random_problem(seed);
    impulse.resize(0);
    const auto before = Clock::now();
    const contensou::SolverReport report = solver.solve(random.problem, impulse);
    const double seconds = std::chrono::duration<double>(Clock::now() - before).count();

    const double residual = natural_map_residual(random.problem, impulse);
    const bool good = residual <= solved;
    outcome.seconds += seconds;
    outcome.iterations.push_back(report.iterations);
    if (good) {
      outcome.times.push_back(seconds);
      const double inclusion = random_contact::inclusion_residual(random.problem, impulse);
      outcome.worst_inclusion = std::max(outcome.worst_inclusion, inclusion);
      double allowed = solved;
      if (inclusion > 2 * allowed) {
        allowed += roundings * random_contact::rounding_spread(random.problem, impulse);
      }
      outcome.inclusion_ratio = std::max(outcome.inclusion_ratio, inclusion / (2 * allowed));
    } else if (at_rounding(random.problem, impulse, residual)) {
      ++outcome.at_rounding;
    }
    const auto add = [&](Count& count) {
      ++count.problems;
      if (!good) ++count.unsolved;
      count.worst = std::max(count.worst, residual);
    };
    add(outcome.all);
    for (const auto& key : classes_of(random)) add(outcome.classes[key]);
    if ((seed + 1) % 20000 == 0) {
      std::printf("\r%-18s %6d problems, %d unsolved", method.name.c_str(), outcome.all.problems,
                  outcome.all.unsolved);
      std::fflush(stdout);
    }
  }
  std::printf(" (%d of them at rounding), worst residual %.1e, %.1f s\n", outcome.at_rounding,
              outcome.all.worst, outcome.seconds);
  std::sort(outcome.iterations.begin(), outcome.iterations.end());
  std::sort(outcome.times.begin(), outcome.times.end());
  return outcome;
}

template <class Value>
Value quantile(const std::vector<Value>& sorted, double q) {
  return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
}

class Report {
 public:
  void add(const Method& method, const Outcome& o) {
    const auto number = [](auto value) { return static_cast<double>(value); };
    overall_.add({method.name, number(o.all.problems), number(o.all.unsolved), number(o.at_rounding),
                  o.all.worst, o.worst_inclusion, number(quantile(o.iterations, 0.5)),
                  number(quantile(o.iterations, 0.99)), number(o.iterations.back()), o.seconds,
                  1e6 * o.seconds / o.all.problems});
    for (const auto& [key, count] : o.classes) {
      classes_.add(
          {method.name, key.first, key.second, number(count.problems), number(count.unsolved), count.worst});
    }
    for (int i = 0; i <= points; ++i) {
      const double share = number(i) / points;
      profile_.add({method.name, quantile(o.times, share), share * number(o.times.size()) / o.all.problems});
    }
  }

  void write(const std::filesystem::path& folder) const {
    contensou::write_table(overall_, folder / "robustness.tsv");
    contensou::write_table(classes_, folder / "robustness_by_class.tsv");
    contensou::write_table(profile_, folder / "robustness_profile.tsv");
  }

 private:
  static constexpr int points = 400;
  contensou::Table overall_{
      {"Random contact problems (random_problems.hpp), cold start, tolerance 1e-10.",
       "unsolved: natural_map_residual above 1e-10; at_rounding: of these, those no better than doubles can "
       "be: residual <= 16 times, inclusion <= 32 times what one rounding of Lambda does, measured in long "
       "double.",
       "inclusion: worst residual of the solved in the contact laws as written, without projections.",
       "iterations: as each method counts them; seconds: of all problems, unsolved ones included."},
      {"method", "problems", "unsolved", "at_rounding", "worst_residual", "worst_inclusion",
       "iterations_median", "iterations_99", "iterations_max", "seconds", "microseconds_per_problem"},
      {}};
  contensou::Table classes_{{"Random contact problems by class: unsolved at 1e-10 and worst residual."},
                            {"method", "by", "class", "problems", "unsolved", "worst_residual"},
                            {}};
  contensou::Table profile_{{"Share of all problems solved to 1e-10 within a time per problem."},
                            {"method", "seconds", "solved"},
                            {}};
};

void claim(const Outcome& o, Record& record) {
  const double lost = o.all.unsolved - o.at_rounding;
  record.add(
      Claim{"contact.automatic.unsolved", "LG03 (4.17)",
            "random problems of " + std::to_string(o.all.problems) +
                " that the default solver leaves above 1e-10, but for those where no doubles are better",
            0, lost, lost, 0, true});
  // 16 roundings are 1e-10 where |W||Λ| = 6e4 V. Impulses are V over the distance of a wedge's self-stress
  // from the border of the friction cone, and that has a density of the order of 1: 1/6e4 for each of up to
  // 28 pairs of contacts, in the two of five structures that have loops: 2e-4, and 5 times that for
  // a density that is not known.
  const double share = static_cast<double>(o.at_rounding) / o.all.problems;
  record.add(
      Claim{"contact.automatic.rounding", "LG03 (4.17)",
            "share of random problems whose impulses are so large that doubles have no better ones than the "
            "default solver's, residual above 1e-10",
            0, share, share, 1e-3, true});
  // The natural map takes γ in doubles, the inclusion in long double: their roundings come on top of 1e-10.
  record.add(
      Claim{"contact.automatic.inclusion", "LG03 (4.8)",
            "worst residual of the default solver's solutions in the contact laws as written, over twice "
            "1e-10 and the roundings of gamma: no projection involved (without the roundings: obtained)",
            0, o.worst_inclusion, o.inclusion_ratio, 1, true});
  // 30 + 130 + 90 iterations; 40 proximal steps of 30 + 30 before the paths and after every eighth; 24 paths
  // of 300 steps with 100 + 20 + 30 iterations after each.
  const double most = 30 + 130 + 90 + 4 * 40 * (30 + 30) + 24 * (300 + 100 + 20 + 30);
  record.add(Claim{
      "contact.automatic.bounded", "LG03 4.1",
      "largest number of iterations of the default solver, Newton iterations, sweeps and steps alike", most,
      static_cast<double>(o.iterations.back()), static_cast<double>(o.iterations.back()), most, true});
}

int run(const std::filesystem::path& folder) {
  Record record("contact");
  Report report;
  for (const Method& method : methods) {
    const Outcome outcome = run_method(method);
    report.add(method, outcome);
    if (method.method == SolverMethod::automatic) claim(outcome, record);
  }
  report.write(folder);
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::contact

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::contact::run); }
