#include "contensou/system/harmonic_oscillator.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "differences.hpp"

using namespace contensou;
using namespace system_test;

TEST_CASE("Harmonic oscillator: its terms, and that it oscillates", "[system]") {
  const HarmonicOscillator oscillator({.m = 1.3, .k = 0.7});
  const double rate_of_phase = oscillator.frequency();
  CHECK(std::abs(rate_of_phase * rate_of_phase - 0.7 / 1.3) <= 1e-15);
  const auto position = [&](double t) { return 0.8 * std::cos(rate_of_phase * t + 0.3); };
  const auto velocity = [&](double t) { return -0.8 * rate_of_phase * std::sin(rate_of_phase * t + 0.3); };
  for (const double t : {0.0, 1.1, 2.7}) {
    const State s{t, Eigen::VectorXd{{position(t)}}, Eigen::VectorXd{{velocity(t)}}};
    check_terms(oscillator, s);
    Eigen::VectorXd a(1);
    oscillator.free_acceleration(t, s.q, s.u, a);
    CHECK(std::abs(a[0] - rate([&](double dt) { return velocity(t + dt); })) <= difference_bound);
    CHECK(std::abs(oscillator.kinetic_energy(s.q, s.u) + oscillator.potential_energy(s.q) -
                   0.7 * 0.8 * 0.8 / 2) <= 1e-15);
  }
}

TEST_CASE("Harmonic oscillator: without contact; bad data give one clear line", "[system]") {
  const HarmonicOscillator oscillator({});
  CHECK(oscillator.contacts().empty());
  CHECK_THROWS_AS(oscillator.gap(0, 0, Eigen::VectorXd::Zero(1)), std::out_of_range);
  CHECK_THROWS_WITH(HarmonicOscillator({.m = -1}), "harmonic oscillator: m -1, expected a number > 0");
  CHECK_THROWS_WITH(HarmonicOscillator({.k = INFINITY}),
                    "harmonic oscillator: k inf, expected a number >= 0");
}
