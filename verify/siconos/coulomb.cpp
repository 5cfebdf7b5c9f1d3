#include "coulomb.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "contensou/contact/contact_solver.hpp"
#include "contensou/output/table.hpp"
#include "coulomb_problems.hpp"
#include "rivals/siconos.hpp"

namespace verify::siconos {
namespace {

using contensou::SolverMethod;

constexpr double our_tolerance = 1e-12;
constexpr double their_tolerance = 1e-10;  ///< of Siconos's measure; its default is 1e-4 to 1e-10
constexpr double solved = 1e-8;            ///< natural-map residual below which a problem counts as solved
constexpr int most_iterations = 2000;      ///< of Siconos's solvers

/// What a solver made of one problem.
struct Found {
  Eigen::VectorXd impulse;
  bool claimed;          ///< it says that it has converged
  double residual;       ///< ours, natural_map_residual
  double siconos_error;  ///< theirs, fc3d_compute_error
};

struct Solver {
  std::string origin, name;
  std::optional<SolverMethod> method;  ///< of ours
  bool one_contact;
  rivals::SiconosProblem::Storage storage;
};

std::vector<Solver> solvers() {
  using Storage = rivals::SiconosProblem::Storage;
  std::vector<Solver> all{
      {"contensou", "automatic", SolverMethod::automatic, false, Storage::dense},
      {"contensou", "semismooth_newton", SolverMethod::semismooth_newton, false, Storage::dense},
      {"contensou", "gauss_seidel", SolverMethod::gauss_seidel, false, Storage::dense},
      {"contensou", "modified_newton", SolverMethod::modified_newton, false, Storage::dense}};
  for (const rivals::SiconosMethod& m : rivals::siconos_methods()) {
    all.push_back({"siconos", m.name, {}, m.one_contact, m.storage});
  }
  return all;
}

rivals::SiconosProblem siconos_problem(const CoulombProblem& p, rivals::SiconosProblem::Storage storage) {
  return {p.problem.delassus, p.problem.free_velocity, p.mu, storage};
}

Found solve(const Solver& solver, const CoulombProblem& p) {
  Found found;
  found.impulse = Eigen::VectorXd::Zero(p.problem.rows());
  if (solver.method) {
    contensou::ContactSolver ours({.method = *solver.method, .tolerance = our_tolerance});
    found.claimed = ours.solve(p.problem, found.impulse).status == contensou::SolverStatus::solved;
  } else {
    rivals::SiconosProblem theirs = siconos_problem(p, solver.storage);
    rivals::SiconosSolver siconos(solver.name, their_tolerance, most_iterations);
    Eigen::VectorXd velocity = p.problem.free_velocity;
    found.claimed = siconos.solve(theirs, found.impulse, velocity).info == 0;
  }
  if (!found.impulse.allFinite()) found.impulse.setZero();
  found.residual = natural_map_residual(p.problem, found.impulse);
  found.siconos_error = siconos_problem(p, rivals::SiconosProblem::Storage::dense).error(found.impulse);
  return found;
}

/// The largest rounding error of γ = WΛ + b, relative to the largest |b| = 1, as both measures see it.
double rounding(const CoulombProblem& p, const Eigen::VectorXd& impulse) {
  const auto terms = static_cast<double>(impulse.size()) + 3;
  return terms * 0x1p-52 *
         (1 + impulse.cwiseAbs().maxCoeff() +
          (p.problem.delassus.cwiseAbs() * impulse.cwiseAbs()).maxCoeff());
}

/// How much larger than ours (h, a length per contact) Siconos's measure can be. A residual h makes (Λ − h, γ
/// − h) an exact solution; De Saxcé's map is zero there and moves by at most (1 + μ)‖h‖ for a shift of both
/// by h. Siconos sums squares over n contacts and divides by ‖b‖ >= max|b|.
double theirs_by_ours(const CoulombProblem& p) {
  const double mu = *std::max_element(p.mu.begin(), p.mu.end());
  return (1 + mu) * std::sqrt(static_cast<double>(p.mu.size()));
}

/// The other way: De Saxcé's residual d makes (Λ − d, γ − (1 + μ)d-ish) exact, and our map, in which the disk
/// follows the normal impulse, moves by at most d + (1 + μ)(d + (1 + μ)d). Siconos divides by the largest of
/// ‖b‖, ‖Λ‖ and ‖γ‖.
double ours_by_theirs(const CoulombProblem& p, const Eigen::VectorXd& impulse) {
  const double mu = *std::max_element(p.mu.begin(), p.mu.end());
  const Eigen::VectorXd& b = p.problem.free_velocity;
  const double scale = std::max({b.norm(), impulse.norm(), (p.problem.delassus * impulse + b).norm()});
  return (1 + (1 + mu) * (2 + mu)) * scale;
}

/// How far apart two velocities can be whose impulses have natural-map residuals up to `residual`, where the
/// solution is unique; infinite where that is not sure. With fixed disks the inclusion is strongly monotone:
/// ‖ΔΛ‖ <=
/// ((1 + L)/λ_min) √n · residual, L = ‖W‖; disks that follow the normal impulse add μ(1 + L)/λ_min of ΔΛ.
double velocity_bound(const CoulombProblem& p, double residual) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(p.problem.delassus, Eigen::EigenvaluesOnly);
  const double least = eigen.eigenvalues().minCoeff();
  const double most = eigen.eigenvalues().maxCoeff();
  const double mu = *std::max_element(p.mu.begin(), p.mu.end());
  const double condition = (1 + most) / least;
  const double feedback = mu * condition;
  if (!(least > 0) || feedback >= 1) return std::numeric_limits<double>::infinity();
  return most * condition / (1 - feedback) * std::sqrt(static_cast<double>(p.mu.size())) * residual;
}

struct Tally {
  int problems = 0, unsolved = 0, false_claims = 0;
  double worst_residual = 0;       ///< of the solved ones
  double worst_siconos_error = 0;  ///< of the solved ones
  double worst_velocity = 0;       ///< difference to ours where unique
};

struct Ratios {
  double theirs = 0;    ///< our solutions in Siconos's measure, over the bound
  double ours = 0;      ///< Siconos's solutions in our measure, over the bound
  double velocity = 0;  ///< differences of velocities, over the bound
  double error = 0;     ///< the largest Siconos error of a solution of ours
  int easy = 0;         ///< results for easy problems
  int compared = 0;     ///< those of them with a unique velocity
};

void judge(const Solver& solver, const CoulombProblem& p, const Found& reference, const Found& found,
           Tally& tally, Ratios& ratios) {
  ++tally.problems;
  const bool good = found.residual <= solved;
  if (!good) ++tally.unsolved;
  if (!good && found.claimed) ++tally.false_claims;
  const double noise = rounding(p, found.impulse);
  if (solver.origin == "siconos" && found.impulse.size() > 0) {
    ratios.ours = std::max(
        ratios.ours, found.residual / (ours_by_theirs(p, found.impulse) * (found.siconos_error + noise)));
  }
  if (!good) return;
  tally.worst_residual = std::max(tally.worst_residual, found.residual);
  tally.worst_siconos_error = std::max(tally.worst_siconos_error, found.siconos_error);
  if (solver.name == "automatic") {
    ratios.error = std::max(ratios.error, found.siconos_error);
    ratios.theirs =
        std::max(ratios.theirs, found.siconos_error / (theirs_by_ours(p) * (found.residual + noise)));
  }
  if (!p.well_conditioned) return;
  ++ratios.easy;
  const double bound = velocity_bound(p, found.residual + reference.residual + noise);
  if (std::isinf(bound)) return;
  const double difference = (p.problem.delassus * (found.impulse - reference.impulse)).norm();
  tally.worst_velocity = std::max(tally.worst_velocity, difference);
  ratios.velocity = std::max(ratios.velocity, difference / bound);
  ++ratios.compared;
}

contensou::Table table_of(const std::vector<std::string>& families, const std::vector<Solver>& all,
                          const std::vector<std::vector<Tally>>& tallies) {
  contensou::Table table{{"Problems of 1 to 8 Coulomb contacts (R = 0) solved by this library (tolerance "
                          "1e-12 of natural_map_residual) "
                          "and by Siconos Numerics",
                          "(tolerance 1e-10 of fc3d_compute_error, which is relative to the impulses where "
                          "these are large; at most 2000 iterations), both from zero.",
                          "family: hard = random_contact::random_problem, mass ratios to 1e6, "
                          "rank-deficient, mu 0 to 10, each with a "
                          "solution; easy = well-conditioned, mu <= 0.1.",
                          "  Each contact in units in which its own block of W and the largest |b| are 1; "
                          "onecontact_* solvers take "
                          "problems of one contact only.",
                          "unsolved: natural-map residual above 1e-8; false_claims: those of them of which "
                          "the solver says that it has "
                          "converged",
                          "residual (ours), siconos_error (theirs): largest over the solved ones; velocity: "
                          "largest difference to "
                          "`automatic` in units of max|b|, easy problems with a unique solution"},
                         {"family", "origin", "solver", "problems", "unsolved", "false_claims", "residual",
                          "siconos_error", "velocity"},
                         {}};
  for (std::size_t f = 0; f < families.size(); ++f) {
    for (std::size_t s = 0; s < all.size(); ++s) {
      const Tally& t = tallies[f][s];
      table.add({families[f], all[s].origin, all[s].name, static_cast<double>(t.problems),
                 static_cast<double>(t.unsolved), static_cast<double>(t.false_claims), t.worst_residual,
                 t.worst_siconos_error, t.worst_velocity});
      std::printf("  %s %-9s %-24s unsolved %3d of %3d (claims to have solved %d), residual %7.1e\n",
                  families[f].c_str(), all[s].origin.c_str(), all[s].name.c_str(), t.unsolved, t.problems,
                  t.false_claims, t.worst_residual);
    }
  }
  return table;
}

}  // namespace

void check_coulomb(Record& record, const std::filesystem::path& folder) {
  const std::vector<std::string> families{"hard", "easy"};
  const std::vector<std::vector<CoulombProblem>> problems{hard_problems(300), easy_problems(200, 2003)};
  const std::vector<Solver> all = solvers();
  std::vector<std::vector<Tally>> tallies(families.size(), std::vector<Tally>(all.size()));
  Ratios ratios;
  for (std::size_t f = 0; f < families.size(); ++f) {
    const rivals::Silence silence;
    for (const CoulombProblem& p : problems[f]) {
      const Found reference = solve(all[0], p);
      for (std::size_t s = 0; s < all.size(); ++s) {
        if (all[s].one_contact && p.mu.size() > 1) continue;
        judge(all[s], p, reference, s == 0 ? reference : solve(all[s], p), tallies[f][s], ratios);
      }
    }
  }
  contensou::write_table(table_of(families, all, tallies), folder / "siconos_coulomb.tsv");

  const double unsolved = tallies[0][0].unsolved + tallies[1][0].unsolved;
  record.add(Claim{"siconos.coulomb.unsolved", "LG03 (4.17)",
                   "the default solver leaves none of 500 Coulomb problems unsolved", 0, unsolved, unsolved,
                   0, true});
  record.add(
      Claim{"siconos.coulomb.ours_in_theirs", "Siconos, fc3d_compute_error",
            "our solutions in Siconos's measure of error, over what our residual allows, (1 + mu) sqrt(n)", 1,
            ratios.theirs, ratios.theirs, 1, true});
  // μ <= 10, n <= 8 and a residual of 1e-12 allow 3.1e-11; rounding of WΛ where W is rank-deficient adds to
  // it.
  record.add(Claim{"siconos.coulomb.error", "Siconos, fc3d_compute_error",
                   "the largest error of our solutions in Siconos's measure", 0, ratios.error, ratios.error,
                   1e-10, true});
  record.add(Claim{"siconos.coulomb.theirs_in_ours", "contact_problem.hpp, natural_map_residual",
                   "Siconos's results, solved or not, in our measure, over what its own error allows", 1,
                   ratios.ours, ratios.ours, 1, true});
  record.add(
      Claim{"siconos.coulomb.velocity", "Siconos, fc3d_driver",
            "velocities of all solvers where they are unique, difference over what the residuals allow", 1,
            ratios.velocity, ratios.velocity, 1, true});
  const double left_out = 1 - static_cast<double>(ratios.compared) / std::max(ratios.easy, 1);
  record.add(Claim{"siconos.coulomb.compared", "Siconos, fc3d_driver",
                   "share of the easy problems' results whose velocity is not sure to be unique", 0, left_out,
                   left_out, 0.5, true});
}

}  // namespace verify::siconos
