// What must hold at every solution of a contact problem, on random problems: friction takes energy, at the
// rate Φ; impacts add none; the order of contacts does not matter. Writes consistency.tsv. verify_consistency
// [--out FOLDER]

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "checks.hpp"
#include "common/program.hpp"
#include "contact/random_problems.hpp"
#include "contensou/contact/blocks.hpp"
#include "contensou/output/table.hpp"
#include "record.hpp"
#include "uniqueness.hpp"

namespace verify::consistency {
namespace {

using contensou::ContactProblem;

constexpr std::uint64_t problems = 12000;
constexpr double solved = 1e-10;  // the target of the default method
constexpr double restitution = 0.8;

/// A check's outcome over many problems.
struct Tally {
  int problems = 0;
  int beyond = 0;    ///< the bound
  double worst = 0;  ///< in the measure of the bound
  double bound;

  void add(double value) {
    ++problems;
    worst = std::max(worst, std::isnan(value) ? std::numeric_limits<double>::infinity() : value);
    if (!(value <= bound)) ++beyond;
  }
};

/// The checks, each by kind of rows.
class Tallies {
 public:
  void add(const std::string& check, const std::string& rows, double bound, double value) {
    for (const std::string& name : {rows, std::string("all")}) {
      auto [place, is_new] = tallies_.try_emplace({check, name});
      if (is_new) place->second.bound = bound;
      place->second.add(value);
    }
  }
  const Tally& at(const std::string& check) const { return tallies_.at({check, "all"}); }
  bool has(const std::string& check) const { return tallies_.count({check, "all"}) > 0; }

  contensou::Table table() const {
    contensou::Table table{
        {"Consistency of solutions of random contact problems, default solver to 1e-12; V = max|b|, r as in "
         "the "
         "natural map.",
         "created: max over contacts of lambda_F.gamma_F, potential: of |lambda_F.gamma_F + Phi|, both "
         "relative to "
         "V (mu lambda_N + |lambda_F| + (1 + mu) r |gamma_F|).",
         "impact...: kinetic energy added, relative to V times the sum of |Lambda| + r |gamma|; one = one "
         "contact; "
         "restitution 0.8 where not inelastic.",
         "order: |difference of gamma| between two orders of contacts over its bound from both residuals, "
         "where the "
         "solution is provably unique; order_elsewhere: relative to V, not proven unique."},
        {"check", "rows", "problems", "worst", "bound", "beyond"},
        {}};
    for (const auto& [key, tally] : tallies_) {
      table.add({key.first, key.second, static_cast<double>(tally.problems), tally.worst, tally.bound,
                 static_cast<double>(tally.beyond)});
    }
    return table;
  }

 private:
  std::map<std::pair<std::string, std::string>, Tally> tallies_;
};

/// Problems asked beside the random ones: of those not solved, how many doubles cannot solve any better.
struct Asked {
  int problems = 0;
  int at_rounding = 0;
  int unsolved = 0;  ///< and not at rounding

  /// Whether it is solved.
  bool add(const Solution& s) {
    ++problems;
    if (s.residual <= solved) return true;
    ++(s.at_rounding ? at_rounding : unsolved);
    return false;
  }
};

/// Newton's restitution, the same for all contacts, with b as the velocity before.
ContactProblem with_restitution(ContactProblem problem) {
  contensou::for_each_contact(problem, [&](const auto& group, Eigen::Index i) {
    problem.free_velocity[group.row(i)] *= 1 + restitution;
  });
  return problem;
}

// The natural map's residual ρ moves Λ by rρV and −γ_F from the normal cone by ρV. That moves Λ_F·γ_F by
// ρV(|Λ_F| + r|γ_F|) and Φ by μρV(Λ_N + r|γ_F|) at most: twice the residual covers both, and the energies,
// where Λ_N γ_N comes in addition, four times.
constexpr double power_bound = 2 * solved;
constexpr double energy_bound = 4 * solved;

void check_energy(const ContactProblem& problem, const std::string& rows, const Solution& inelastic,
                  Tallies& tallies, Asked& asked) {
  tallies.add("impact_inelastic", rows, energy_bound, energy_gained(inelastic, problem.free_velocity));
  const ContactProblem elastic = with_restitution(problem);
  // Restitution can ask for what bodies cannot do, and then there is no solution to look for any longer.
  const Solution s = solve(elastic, 1000);
  if (!asked.add(s)) return;
  const bool frictionless = rows == "frictionless";
  const std::string check = frictionless              ? "impact_frictionless"
                            : problem.contacts() == 1 ? "impact_friction_one"
                                                      : "impact_friction_several";
  tallies.add(check, rows, energy_bound, energy_gained(s, problem.free_velocity));
}

void check_order(const ContactProblem& problem, const std::string& rows, const Solution& s, Tallies& tallies,
                 Asked& asked) {
  if (problem.contacts() < 2 || s.speed == 0) return;  // b = 0: nothing moves
  std::vector<Eigen::Index> order;
  const ContactProblem other = reversed(problem, order);
  const Solution t = solve(other);
  if (!asked.add(t)) return;
  const Eigen::VectorXd difference = t.velocity - s.velocity(order);
  const Uniqueness here = uniqueness(problem);
  if (here.proven) {
    const Uniqueness there = uniqueness(other);
    const double bound = here.amplification * (disturbance(problem, here, s) + disturbance(other, there, t));
    tallies.add("order", rows, 1, there.scale.cwiseProduct(difference).norm() / bound);
    tallies.add("order_plain", rows, 1e-6, difference.lpNorm<Eigen::Infinity>() / s.speed);
  } else {
    tallies.add("order_elsewhere", rows, 1e-6, difference.lpNorm<Eigen::Infinity>() / s.speed);
  }
}

Claim claim(const std::string& id, const std::string& where, const std::string& text, const Tally& tally,
            bool should_hold = true) {
  return {"consistency." + id,
          where,
          text + " (" + std::to_string(tally.problems) + " problems)",
          0,
          tally.worst,
          tally.worst,
          tally.bound,
          should_hold};
}

int run(const std::filesystem::path& folder) {
  Tallies tallies;
  int unsolved = 0;
  long slipping = 0;
  Asked elastic;
  Asked reordered;
  for (std::uint64_t seed = 0; seed < problems; ++seed) {
    const random_contact::RandomProblem random = random_contact::random_problem(seed);
    const ContactProblem& problem = random.problem;
    const std::string rows(random_contact::row_kinds[static_cast<std::size_t>(random.rows)]);
    const Solution s = solve(problem);
    if (!(s.residual <= solved)) {
      if (!s.at_rounding) ++unsolved;
      continue;
    }
    if (rows != "frictionless") {
      const Power power = frictional_power(problem, s);
      tallies.add("created", rows, power_bound, power.created);
      tallies.add("potential", rows, power_bound, power.apart_from_potential);
      slipping += power.slipping;
    }
    check_energy(problem, rows, s, tallies, elastic);
    check_order(problem, rows, s, tallies, reordered);
  }
  contensou::write_table(tallies.table(), folder / "consistency.tsv");
  for (const std::string& line :
       {std::string("created"), std::string("potential"), std::string("impact_inelastic"),
        std::string("impact_frictionless"), std::string("impact_friction_one"),
        std::string("impact_friction_several"), std::string("order"), std::string("order_plain"),
        std::string("order_elsewhere")}) {
    if (!tallies.has(line)) continue;
    const Tally& t = tallies.at(line);
    std::printf("%-24s %6d problems, worst %9.2e, bound %9.2e, beyond it %d\n", line.c_str(), t.problems,
                t.worst, t.bound, t.beyond);
  }
  std::printf("%ld slipping contacts; %d of %d problems not solved to %g\n", slipping, unsolved,
              static_cast<int>(problems), solved);
  for (const auto& [what, asked] :
       {std::pair{"with restitution", elastic}, std::pair{"reversed", reordered}}) {
    std::printf("%d problems %s, %d at rounding, %d not solved\n", asked.problems, what, asked.at_rounding,
                asked.unsolved);
  }

  Record record("consistency");
  record.add(Claim{"consistency.solved", "LG03 (4.17)",
                   "random problems that the default solver does not solve to 1e-10 nor to rounding", 0,
                   static_cast<double>(unsolved), static_cast<double>(unsolved), 0, true});
  record.add(claim("created", "LG03 (2.1), (2.20)", "friction never creates energy: lambda_F.gamma_F <= 0",
                   tallies.at("created")));
  record.add(claim("potential", "LG03 (2.1)", "the power of friction is -Phi(gamma_F), in slip and in stick",
                   tallies.at("potential")));
  record.add(claim("impact.inelastic", "LG03 (4.7), (4.8)", "a completely inelastic impact adds no energy",
                   tallies.at("impact_inelastic")));
  record.add(claim("impact.frictionless", "Newton's impact law",
                   "without friction, impacts with the same restitution for all contacts add no energy",
                   tallies.at("impact_frictionless")));
  // Not so. The energy added is ½Λ·(γ⁺ + γ⁻), and Λ_F·γ_F⁻ = Λ_F·γ_F⁺ − Λ_F·(W_FN Λ_N + W_FF Λ_F) has any
  // sign.
  record.add(claim("impact.friction.one",
                   "Newton's impact law; against it Kane & Levinson, Dynamics: Theory and Applications, 1985",
                   "with friction, the impact of one contact with restitution 0.8 adds no energy",
                   tallies.at("impact_friction_one"), false));
  record.add(Claim{"consistency.order.solved", "LG03 (4.17)",
                   "solved problems that the default solver does not solve to 1e-10 nor to rounding with "
                   "their contacts in reverse order (" +
                       std::to_string(reordered.problems) + " problems)",
                   0, static_cast<double>(reordered.unsolved), static_cast<double>(reordered.unsolved), 0,
                   true});
  record.add(claim("order", "LG03 (4.17)",
                   "velocities do not depend on the order of contacts where the solution is provably unique: "
                   "difference over its bound (from the defects of the library's own projection)",
                   tallies.at("order")));
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::consistency

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::consistency::run); }
