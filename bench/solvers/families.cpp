#include "families.hpp"

#include <algorithm>
#include <random>
#include <variant>

#include "common/natural_units.hpp"
#include "contact/random_problems.hpp"
#include "contensou/contact/contact_solver.hpp"

namespace bench {
namespace {

using contensou::ContactGroup;
using contensou::ContactProblem;
using random_contact::RandomProblem;

constexpr std::size_t single = 600;  ///< problems of one contact
constexpr std::size_t several = 40;

bool opens_at_once(const ContactProblem& problem) {
  Eigen::Index row = 0;
  for (const ContactGroup& group : problem.groups) {
    for (std::size_t i = 0; i < group.mu.size(); ++i, row += contensou::rows(*group.friction)) {
      if (problem.free_velocity[row] < 0) return false;
    }
  }
  return true;
}

template <class Friction>
bool all_are(const ContactProblem& problem) {
  return std::all_of(problem.groups.begin(), problem.groups.end(), [](const ContactGroup& group) {
    return group.mu.empty() || std::holds_alternative<Friction>(*group.friction);
  });
}

template <class Friction>
bool of(const RandomProblem& random) {
  return all_are<Friction>(random.problem);
}

bool all_have_four_rows(const RandomProblem& random) {
  const ContactProblem& problem = random.problem;
  return std::all_of(problem.groups.begin(), problem.groups.end(), [](const ContactGroup& group) {
    return group.mu.empty() || contensou::rows(*group.friction) == 4;
  });
}

Case cold(const ContactProblem& problem) { return {problem, Eigen::VectorXd::Zero(problem.rows())}; }

/// From the solution before b moved.
Case warm(const ContactProblem& problem, std::mt19937_64& engine) {
  Case c = cold(problem);
  ContactProblem before = problem;
  const double largest = problem.free_velocity.cwiseAbs().maxCoeff();
  for (double& b : before.free_velocity) {
    b += 0.01 * largest * (2 * static_cast<double>(engine() >> 11) * 0x1p-53 - 1);
  }
  contensou::ContactSolver solver;
  const contensou::SolverReport report = solver.solve(before, c.guess);
  if (report.status != contensou::SolverStatus::solved) c.guess.setZero();
  return c;
}

template <class Wanted>
Family family(std::string name, bool coulomb, bool one_contact, const Wanted& wanted) {
  Family found{std::move(name), coulomb, one_contact, {}, {}};
  std::mt19937_64 engine(2003);
  for (std::uint64_t seed = 0; found.cold.size() < (one_contact ? single : several); ++seed) {
    const RandomProblem random = random_contact::random_problem(seed);
    const ContactProblem& problem = random.problem;
    if ((problem.contacts() == 1) != one_contact || opens_at_once(problem) || !wanted(random)) continue;
    const ContactProblem scaled = in_natural_units(problem);
    found.cold.push_back(cold(scaled));
    found.warm.push_back(warm(scaled, engine));
  }
  return found;
}

}  // namespace

std::vector<Family> families() {
  using namespace contensou;
  const auto coulomb = [](const RandomProblem& random) { return all_are<FrictionDisk>(random.problem); };
  const auto free = [&](const RandomProblem& random) {
    using random_contact::Motion;
    return coulomb(random) && random.structure == random_contact::Structure::tree &&
           (random.motion == Motion::impact || random.motion == Motion::sliding);
  };
  return {family("coulomb_1", true, true, coulomb),
          family("coulomb_1_free", true, true, free),
          family("uniform_1", false, true, of<FrictionBall<SmoothPlate<UniformLaw>>>),
          family("hertz_1", false, true, of<FrictionBall<SmoothPlate<HertzLaw>>>),
          family("coulomb_n", true, false, coulomb),
          family("contensou_n", false, false, all_have_four_rows)};
}

}  // namespace bench
