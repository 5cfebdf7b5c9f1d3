#include "contensou/integrate/method_limits.hpp"

#include <catch2/catch.hpp>

#include "stepping_problems.hpp"

using namespace contensou;
using namespace stepping_problems;

namespace {

/// What is said of a run with this method; nothing where it runs.
std::string refusal(const MechanicalSystem& system, IntegratorOptions options) {
  State state = Slab::at(0, {1, 0, 0, 2});
  options.step = 1e-3;
  try {
    static_cast<void>(integrate(system, state, 2e-3, options));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

constexpr Method in_time[] = {Method::moreau, Method::moreau_implicit, Method::moreau_adaptive};
constexpr Method others[] = {Method::moreau_printed, Method::rk4_printed, Method::rk4, Method::event_driven};

}  // namespace

TEST_CASE("Method limits: a radius that follows the load", "[integrate][method_limits]") {
  SystemContact floor{"floor", FrictionBall(SmoothPlate(HertzLaw{})), 0.3, 0.5, 0};
  floor.load_radius = LoadRadius{0.1, 1e6};
  for (const Method method : in_time) CHECK(refusal(Slab(floor), {.method = method}).empty());
  for (const Method method : others) {
    CHECK(refusal(Slab(floor), {.method = method}) ==
          std::string("contact floor: a radius that follows the load with method ") + name(method) +
              ", expected moreau, moreau_implicit or moreau_adaptive");
  }
  // A point contact has no radius.
  floor.friction = FrictionDisk{};
  CHECK(refusal(Slab(floor), {.method = Method::event_driven}).empty());
}

TEST_CASE("Method limits: fidelity", "[integrate][method_limits]") {
  const Slab slab({"floor", FrictionBall(SmoothPlate(HertzLaw{})), 0.3, 0.5, 0});
  for (const Method method : in_time) CHECK(refusal(slab, {.method = method, .fidelity = 0.1}).empty());
  for (const Method method : others) {
    CHECK(refusal(slab, {.method = method, .fidelity = 0.1}) ==
          std::string("integrator: fidelity with method ") + name(method) +
              ", expected moreau, moreau_implicit, moreau_adaptive or nscd");
  }
}

TEST_CASE("Method limits: uncoupled friction has no smooth border", "[integrate][method_limits]") {
  const Slab slab({"floor", FrictionCylinder(0.6), 0.3, 0.5, 0});
  for (const Method method : in_time) CHECK(refusal(slab, {.method = method}).empty());
  for (const Method method : others) {
    CHECK(refusal(slab, {.method = method}) ==
          std::string("contact floor: uncoupled sliding and drilling friction with method ") + name(method) +
              ", expected moreau, moreau_implicit, moreau_adaptive or nscd");
  }
}
