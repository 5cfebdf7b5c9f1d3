#include "contensou/ball/bracketed_newton.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace contensou;

TEST_CASE("bracketed Newton: quadratic on a smooth function", "[bracketed_newton]") {
  const NewtonEnd end = bracketed_newton({0, 1}, 0.5, [](double x) {
    return NewtonStep{0.5 - x * x, 2 * x, false};
  });
  CHECK(std::abs(end.x - std::sqrt(0.5)) <= 2e-16);
  CHECK(end.iterations <= 7);
}

TEST_CASE("bracketed Newton: ends whatever the function", "[bracketed_newton]") {
  // A step: no derivative is any help. 53 halvings of (0, 1] and no more.
  const auto step = [](double x) { return NewtonStep{x < 0.3 ? 1.0 : -1.0, 1e-9, false}; };
  const NewtonEnd end = bracketed_newton({0, 1}, 0.5, step);
  CHECK(std::abs(end.x - 0.3) <= 1e-16);
  CHECK(end.iterations <= 56);
  // Slopes of the wrong sign, and none at all.
  for (const double fall : {-1.0, 0.0, std::nan("")}) {
    const NewtonEnd bisected = bracketed_newton({0, 1}, 0.9, [=](double x) {
      return NewtonStep{0.3 - x, fall, false};
    });
    CHECK(std::abs(bisected.x - 0.3) <= 1e-16);
    CHECK(bisected.iterations <= 60);
  }
}

TEST_CASE("bracketed Newton: stops where the caller says so, at the last point evaluated",
          "[bracketed_newton]") {
  double last = 0;
  const NewtonEnd end = bracketed_newton({0, 1}, 0.9, [&](double x) {
    last = x;
    return NewtonStep{0.25 - x * x, 2 * x, std::abs(0.25 - x * x) < 1e-3};
  });
  CHECK(end.x == last);
  CHECK(std::abs(end.x - 0.5) < 1e-3);
}

TEST_CASE("inverse cubic: exact for a line, keeps relative accuracy near 0", "[bracketed_newton]") {
  CHECK(inverse_cubic(3, 4, -1, 4) == 0.75);
  const double h0 = 1e-30;  // h = 1e-30 − 2x − x²: root 5e-31
  CHECK(std::abs(inverse_cubic(h0, 2, h0 - 3, 4) / 5e-31 - 1) <= 4e-16);
}
