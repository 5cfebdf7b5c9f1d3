#include "contensou/integrate/step_control.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace contensou;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("StepControl: a fixed step goes from grid point to grid point, events or not", "[integrate]") {
  IntegratorOptions options;
  options.step = 0.1;
  StepControl control(StepChoice::fixed, options, 1);
  double t = 1;
  for (int k = 1; k <= 1000; ++k) {
    const double h = control.propose(t, 1000, infinite);
    CHECK(h == Approx(0.1).epsilon(1e-10));
    t = control.accept(t, h, 0, 5);
    CHECK(t == 1 + k * 0.1);  // no sum
  }
  // An event a third into the step: the rest of the step follows.
  const double h = control.propose(t, 1000, infinite);
  control.interrupt(h);
  t += h / 3;
  CHECK(control.propose(t, 1000, infinite) == Approx(0.1 * 2 / 3).epsilon(1e-10));
  t = control.accept(t, control.propose(t, 1000, infinite), 0, 5);
  CHECK(t == 1 + 1001 * 0.1);
  // The end comes first.
  CHECK(control.propose(t, t + 0.03, infinite) == Approx(0.03).epsilon(1e-10));
  // Slip that comes to rest in 0.1 is followed to 0.7 of it; then the rest of the step.
  const double part = control.propose(t, 1000, 0.1);
  CHECK(part == Approx(0.07).epsilon(1e-14));
  t = control.accept(t, part, 0, 5);
  CHECK(control.propose(t, 1000, infinite) == Approx(0.03).epsilon(1e-9));
}

TEST_CASE("StepControl: an event at a grid point, or just beside it, takes its place", "[integrate]") {
  for (const double beside : {-1e-16, 0.0, 1e-16, 1e-12, -1e-12, 1e-4}) {
    IntegratorOptions options;
    options.step = 0.1;
    StepControl control(StepChoice::fixed, options, 0);
    const double h = control.propose(0, 1, infinite);
    control.interrupt(h);
    const double t = h + beside;
    CAPTURE(beside);
    CHECK(control.propose(t, 1, infinite) == Approx(0.1 - beside).epsilon(1e-10));
    CHECK(control.accept(t, control.propose(t, 1, infinite), 0, 5) == 0.2);
  }
}

TEST_CASE("StepControl: a fixed step that cannot be computed is tried shorter, once", "[integrate]") {
  IntegratorOptions options;
  options.step = 0.1;
  StepControl control(StepChoice::fixed, options, 0);
  CHECK(control.acceptable(1e9));  // there is no error control
  CHECK(!control.acceptable(infinite));
  control.reject(0.1, infinite, 5);
  const double shorter = control.propose(0, 9, infinite);
  CHECK(shorter < 0.05);
  const double t = control.accept(0, shorter, 0, 5);
  CHECK(control.propose(t, 9, infinite) == Approx(0.1 - shorter).epsilon(1e-10));
}

TEST_CASE("StepControl: an adaptive step follows its error", "[integrate]") {
  const auto next = [](double error, int order, bool accepted) {
    StepControl control(StepChoice::adaptive, {}, 0);
    control.set_first(0.1);
    const double h = control.propose(0, 100, infinite);
    CHECK(h == 0.1);
    CHECK(control.acceptable(error) == accepted);
    if (accepted) {
      CHECK(control.accept(0, h, error, order) == h);
    } else {
      control.reject(h, error, order);
    }
    return control.propose(0.1, 100, infinite);
  };
  // An error of e·h^p wants h e^(−1/p): the step proposed lies below that by a margin of less than a half.
  for (const int order : {4, 8}) {
    for (const double error : {0.2, 0.9, 2.0, 50.0}) {
      const double wanted = 0.1 * std::pow(error, -1.0 / order);
      CAPTURE(order, error);
      CHECK(next(error, order, error <= 1) < wanted);
      CHECK(next(error, order, error <= 1) > wanted / 2);
    }
  }
  CHECK(next(0, 8, true) > 0.2);
  CHECK(next(0, 8, true) < 1.01);      // grows by a bounded factor
  CHECK(next(1e30, 8, false) > 1e-3);  // and falls by one
  CHECK(next(1e30, 8, false) < 0.05);
  CHECK(next(infinite, 8, false) < 0.05);
}

TEST_CASE("StepControl: a step cut short does not shorten the next", "[integrate]") {
  StepControl control(StepChoice::adaptive, {}, 0);
  control.set_first(0.1);
  const double t = control.accept(0, 0.001, 1e-9, 8);
  CHECK(control.propose(t, 100, infinite) == 0.1);
  CHECK(control.propose(t, 100, 0.01) == Approx(0.007).epsilon(1e-14));
  control.interrupt(0.1);
  CHECK(control.propose(t, 100, infinite) == 0.1);
  // After a rejection it does not grow at once.
  control.reject(0.1, 100, 8);
  const double shorter = control.propose(t, 100, infinite);
  control.accept(t, shorter, 1e-6, 8);
  CHECK(control.propose(t, 100, infinite) <= shorter);
}

TEST_CASE("StepControl: implicit where stability limits the explicit method", "[integrate]") {
  IntegratorOptions options;
  options.step = 0.1;
  StepControl fixed(StepChoice::fixed, options, 0);
  // RK4 is stable up to h·rate = 2.785 for real rates.
  CHECK(!fixed.implicit(0.1, 15));
  CHECK(fixed.implicit(0.1, 27.8));
  CHECK(fixed.implicit(0.1, infinite));
  CHECK(!fixed.implicit(0.1, 0));

  // Adaptive: not for one step that is limited, but for a series of them; back when it no longer pays, and
  // then later each time.
  StepControl adaptive(StepChoice::adaptive, {}, 0);
  for (int k = 0; k < 100; ++k) CHECK(!adaptive.implicit(0.1, k % 3 == 0 ? 60 : 1));
  const auto steps_until = [&](bool wanted, double relaxation) {
    int steps = 0;
    while (adaptive.implicit(0.1, relaxation) != wanted && steps < 10000) ++steps;
    return steps;
  };
  const int first = steps_until(true, 60);
  CHECK(first > 3);
  CHECK(first < 20);
  CHECK(steps_until(false, 1) < 20);
  const int second = steps_until(true, 60);
  CHECK(second > first);
  for (int k = 0; k < 100; ++k) CHECK(adaptive.implicit(0.1, 1e6));  // where it pays it stays
}
