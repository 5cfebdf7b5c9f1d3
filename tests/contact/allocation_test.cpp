// No method allocates in a solve of a size it has solved before.

#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "../allocation_counter.hpp"
#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/covering_path.hpp"

using namespace contensou;

namespace {

const AnyFriction frictionless{NoFriction{}};
const AnyFriction point{FrictionDisk{}};
const AnyFriction uniform{FrictionBall(SmoothPlate(UniformLaw{}))};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};
const AnyFriction apart{FrictionCylinder(0.5)};

double number(std::mt19937_64& g) { return static_cast<double>(g() >> 11) * 0x1p-52 - 1; }

/// Contacts of these kinds on bodies with `freedom` coordinates: the fewer, the more redundant.
ContactProblem random_problem(std::mt19937_64& g, const std::vector<const AnyFriction*>& kinds, int freedom) {
  ContactProblem problem;
  for (const AnyFriction* kind : kinds) problem.groups.push_back({kind, {0.3 + 0.2 * number(g)}});
  const auto entry = [&] { return number(g); };
  const Eigen::MatrixXd w = Eigen::MatrixXd::NullaryExpr(freedom, problem.rows(), entry);
  const Eigen::VectorXd velocity = Eigen::VectorXd::NullaryExpr(freedom, entry);
  problem.delassus = w.transpose() * w;
  problem.free_velocity = w.transpose() * velocity;
  return problem;
}

/// Allocations in the second pass over the problems.
long allocations_once_solved(SolverMethod method, const std::vector<ContactProblem>& problems) {
  ContactSolver solver({.method = method, .tolerance = 1e-10, .max_iterations = 2000});
  Eigen::VectorXd impulse = Eigen::VectorXd::Zero(problems.front().rows());
  allocation_counter::reset();
  for (const bool second : {false, true}) {
    for (const ContactProblem& problem : problems) {
      impulse.setZero();
      if (second) allocation_counter::start();
      static_cast<void>(solver.solve(problem, impulse));
      allocation_counter::stop();
    }
  }
  return allocation_counter::count();
}

constexpr std::array methods{SolverMethod::modified_newton, SolverMethod::gauss_seidel,
                             SolverMethod::semismooth_newton, SolverMethod::automatic};

}  // namespace

TEST_CASE("Allocation: none in a solve, whatever the method", "[contact]") {
  if (!allocation_counter::available()) {
    WARN("not counted: this is another C library, or a sanitizer");
    return;
  }
  allocation_counter::start();
  Eigen::VectorXd some(3);
  allocation_counter::stop();
  REQUIRE(allocation_counter::count() > 0);  // the counter counts

  std::mt19937_64 g(2003);
  for (const AnyFriction* kind : {&frictionless, &point, &uniform, &hertz, &apart}) {
    std::vector<ContactProblem> one;
    for (int k = 0; k < 20; ++k) one.push_back(random_problem(g, {kind}, 1 + k % 6));
    for (const SolverMethod method : methods) {
      CAPTURE(kind->index(), static_cast<int>(method));
      CHECK(allocations_once_solved(method, one) == 0);
    }
  }
  std::vector<ContactProblem> several;
  for (int k = 0; k < 20; ++k) {
    several.push_back(random_problem(g, {&frictionless, &point, &uniform, &hertz, &apart, &hertz}, 3 + k));
  }
  for (const SolverMethod method : methods) {
    CAPTURE(static_cast<int>(method));
    CHECK(allocations_once_solved(method, several) == 0);
  }
  // The path, which few problems need.
  ScaledProblem scaled;
  CoveringPathMemory memory;
  allocation_counter::reset();
  int steps = 0;
  for (const bool second : {false, true}) {
    for (const ContactProblem& problem : several) {
      scaled.set(problem);
      if (second) allocation_counter::start();
      steps += follow_covering_path(scaled, {1e-7, 1e3, 100}, memory);
      allocation_counter::stop();
    }
  }
  CHECK(steps > 0);
  CHECK(allocation_counter::count() == 0);
}
