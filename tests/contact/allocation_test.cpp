// No method allocates in a solve of a size it has solved before.

#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>
#include <vector>

#include "contensou/contact/contact_solver.hpp"
#include "contensou/contact/covering_path.hpp"

namespace {

// Counted only between start and end of a Counter: what Catch and other tests do is none of our business.
bool counting = false;
long allocations = 0;

}  // namespace

// Eigen takes its memory from malloc, the standard library from operator new, which calls malloc: this
// program's own malloc counts both, and hands on to the C library's.
extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CONTENSOU_COUNTS_ALLOCATIONS 1
extern "C" {
void* malloc(std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  if (counting) ++allocations;
  return __libc_memalign(alignment, size);
}
}
#endif

using namespace contensou;

namespace {

const AnyFriction frictionless{NoFriction{}};
const AnyFriction point{FrictionDisk{}};
const AnyFriction uniform{FrictionBall(SmoothPlate(UniformLaw{}))};
const AnyFriction hertz{FrictionBall(SmoothPlate(HertzLaw{}))};

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
  allocations = 0;
  for (const bool second : {false, true}) {
    for (const ContactProblem& problem : problems) {
      impulse.setZero();
      counting = second;
      static_cast<void>(solver.solve(problem, impulse));
      counting = false;
    }
  }
  return allocations;
}

constexpr std::array methods{SolverMethod::modified_newton, SolverMethod::gauss_seidel,
                             SolverMethod::semismooth_newton, SolverMethod::automatic};

}  // namespace

TEST_CASE("Allocation: none in a solve, whatever the method", "[contact]") {
#ifndef CONTENSOU_COUNTS_ALLOCATIONS
  WARN("not counted: this is another C library, or a sanitizer");
#else
  counting = true;
  Eigen::VectorXd some(3);
  counting = false;
  REQUIRE(allocations > 0);  // the counter counts

  std::mt19937_64 g(2003);
  for (const AnyFriction* kind : {&frictionless, &point, &uniform, &hertz}) {
    std::vector<ContactProblem> one;
    for (int k = 0; k < 20; ++k) one.push_back(random_problem(g, {kind}, 1 + k % 6));
    for (const SolverMethod method : methods) {
      CAPTURE(kind->index(), static_cast<int>(method));
      CHECK(allocations_once_solved(method, one) == 0);
    }
  }
  std::vector<ContactProblem> several;
  for (int k = 0; k < 20; ++k) {
    several.push_back(random_problem(g, {&frictionless, &point, &uniform, &hertz, &hertz}, 3 + k));
  }
  for (const SolverMethod method : methods) {
    CAPTURE(static_cast<int>(method));
    CHECK(allocations_once_solved(method, several) == 0);
  }
  // The path, which few problems need.
  ScaledProblem scaled;
  CoveringPathMemory memory;
  allocations = 0;
  int steps = 0;
  for (const bool second : {false, true}) {
    for (const ContactProblem& problem : several) {
      scaled.set(problem);
      counting = second;
      steps += follow_covering_path(scaled, {1e-7, 1e3, 100}, memory);
      counting = false;
    }
  }
  CHECK(steps > 0);
  CHECK(allocations == 0);
#endif
}
